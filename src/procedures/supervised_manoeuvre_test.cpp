#include "procedures/supervised_manoeuvre.h"

#include <gtest/gtest.h>

// The boxes of 5.21.2.2 of 4.0.0.
namespace evc::procedures::supervised_manoeuvre {
namespace {

Inputs standing() {
  Inputs in;
  in.mode = Mode::FS;
  in.level = Level::L2;
  in.session_open = true;
  return in;
}

State asked(Inputs in) {
  State state;
  in.selects = true;
  EXPECT_TRUE(step(state, in).requested);
  return state;
}

TEST(SupervisedManoeuvre, ARequestWaitsForItsAnswer) {
  State state;
  Inputs in = standing();
  in.selects = true;
  const Result asks = step(state, in);  // E015, A045
  EXPECT_TRUE(asks.requested);
  EXPECT_TRUE(asks.effects.send.has(Send::manoeuvre_request));
  EXPECT_TRUE(state.waits_for_answer);
  const Result again = step(state, in);  // one at a time
  EXPECT_FALSE(again.requested);
  EXPECT_TRUE(again.effects.send.empty());
}

TEST(SupervisedManoeuvre, AnAuthorisationIsReported) {
  Inputs in = standing();
  State state = asked(in);
  in.authorised = true;
  const Result out = step(state, in);  // E115, A095
  EXPECT_TRUE(out.granted);
  EXPECT_TRUE(out.effects.send.has(Send::position_report));
  EXPECT_TRUE(out.effects.inform.empty());
  EXPECT_FALSE(state.waits_for_answer);
  EXPECT_FALSE(step(state, in).granted) << "no request waits";
}

TEST(SupervisedManoeuvre, ARefusalIsShown) {
  Inputs in = standing();
  State state = asked(in);
  in.refused = true;
  const Result out = step(state, in);  // E215, A220
  EXPECT_FALSE(out.granted);
  EXPECT_TRUE(out.effects.inform.has(Inform::SM_refused));
  EXPECT_TRUE(out.effects.send.empty());
  EXPECT_FALSE(state.waits_for_answer);
}

TEST(SupervisedManoeuvre, WithoutAnAnswerItIsRepeatedThreeTimes) {
  Inputs in = standing();
  State state = asked(in);
  int repeated = 0;
  bool failed = false;
  for (int s = 1; s <= 70 && !failed; ++s) {  // 5.21.4.1
    in.now = Duration{static_cast<double>(s)};
    const Result out = step(state, in);
    repeated += out.effects.send.has(Send::manoeuvre_request) ? 1 : 0;
    failed = out.effects.inform.has(Inform::SM_request_failed);
    EXPECT_EQ(failed, s == 60) << s;
  }
  EXPECT_EQ(repeated, 3);
  EXPECT_FALSE(state.waits_for_answer);
}

TEST(SupervisedManoeuvre, NothingWaitsWithoutSessionLevelOrMode) {
  const auto drops = [](auto change) {
    Inputs in = standing();
    State state = asked(in);
    change(in);
    in.authorised = true;
    EXPECT_FALSE(step(state, in).granted);
    return !state.waits_for_answer;
  };
  EXPECT_TRUE(drops([](Inputs& in) { in.session_open = false; }));
  EXPECT_TRUE(drops([](Inputs& in) { in.level = Level::L1; }));
  for (const Mode mode :
       {Mode::NP, Mode::PS, Mode::SH, Mode::SL, Mode::NL, Mode::UN, Mode::TR, Mode::SF, Mode::IS, Mode::SN, Mode::RV})
    EXPECT_TRUE(drops([mode](Inputs& in) { in.mode = mode; })) << name(mode);
}

}  // namespace
}  // namespace evc::procedures::supervised_manoeuvre
