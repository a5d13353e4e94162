#include "screen/player.h"

#include <algorithm>

namespace evc::screen {
namespace {

constexpr std::int64_t kCycle = 100;  // ms

bool sent_anything(const dmi::Commands& c) {
  const port::DriverActions& a = c.actions;
  return a.selected != 0 || a.acknowledged != 0 || a.driver_id || a.level || a.train_running_number || a.rbc_contact ||
         a.cover || a.network || a.V_sr || a.D_sr || a.set_speed || a.language || c.train_data || c.train_type ||
         c.radio || c.one_radio_system || c.ato_on || c.skip_stop;
}

}  // namespace

dmi::Cell middle_of(const dmi::Rect& r) { return {r.x + r.w / 2, r.y + r.h / 2}; }

Player::Player() : display_(std::make_unique<port::Display>()), state_(std::make_unique<dmi::State>()) {}

void Player::show() {
  display_->now = now();
  dmi::show(*state_, *display_);
  collect();
}

void Player::run_to(std::int64_t ms) {
  for (std::int64_t next = (now_ms_ / kCycle + 1) * kCycle; next <= ms; next += kCycle) {
    now_ms_ = next;
    show();
  }
  now_ms_ = std::max(now_ms_, ms);
  dmi::tick(*state_, now());
  collect();
}

bool Player::press(dmi::Cell at) {
  const bool hit = dmi::press(*state_, at, now());
  collect();
  return hit;
}

void Player::slide(dmi::Cell at) {
  dmi::slide(*state_, at, now());
  collect();
}

void Player::release() {
  dmi::release(*state_, now());
  collect();
}

bool Player::touch(const dmi::Target& target) {
  if (!press(middle_of(target.abs))) return false;
  run_to(now_ms_ + (target.type == dmi::ButtonType::delay ? kDelayed : kTap));
  release();
  show();
  return true;
}

bool Player::touch(dmi::Action action) {
  const auto there = target(action);
  return there && touch(*there);
}

std::optional<dmi::Target> Player::target(dmi::Action action) const {
  for (const dmi::Target& target : dmi::targets(*state_))
    if (target.action == action) return target;
  return std::nullopt;
}

std::unique_ptr<dmi::Screen> Player::screen() const {
  auto screen = std::make_unique<dmi::Screen>();
  dmi::draw(*state_, now(), *screen);
  return screen;
}

void Player::collect() {
  const dmi::Commands commands = dmi::take(*state_);
  for (const dmi::SoundOrder& order : commands.sounds) heard_.push_back({now_ms_, order});
  if (!sent_anything(commands)) return;
  take_acknowledgements(commands);
  take_data(commands);
  sent_.push_back(commands);
}

void Player::take_acknowledgements(const dmi::Commands& commands) {
  const port::DriverActions& actions = commands.actions;
  display_->acks.erase_if([&](const port::AskedAck& asked) {
    return actions.has(asked.what) && (asked.what != Ack::text || asked.id == actions.acknowledged_text);
  });
  if (actions.has(Ack::brake)) display_->brake = false;
  if (!actions.has(Ack::text)) return;
  for (port::DisplayedText& text : display_->texts)
    if (text.id == actions.acknowledged_text) text.acknowledge = false;
}

void Player::take_data(const dmi::Commands& commands) {
  if (commands.actions.driver_id) display_->data.stored.driver_id = *commands.actions.driver_id;
  if (!commands.train_data) return;
  display_->data.stored.train = *commands.train_data;
  display_->data.stored.train_status = DataStatus::valid;
}

}  // namespace evc::screen
