#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <vector>

#include "track/testing.h"
#include "track/withdraw.h"

// The track description against a model that keeps every metre of the track: after random sequences of messages,
// revocations, shortenings and resets both give the same speeds, gradients, conditions and authority. The rules of the
// model are those of 3.7.2.3, 3.7.3.1 and A.3.4, in their simplest form.
namespace evc::track {
namespace {

using namespace testing;

constexpr int kMetres = 4000;
constexpr int kTrain = 30;  // m
constexpr int kUnknown = -1000;
constexpr SpeedCode kNone = kNoSpeed;

/// What is stored at one metre.
struct Metre {
  int V = kUnknown;  // code of the SSP
  bool V_front = false;
  int permille = kUnknown;
  SpeedCode axle = kNone;
  bool axle_front = false;
  SpeedCode pbd = kNone;
  SpeedCode signalling = kNone;
  unsigned kinds = 0;  // bit k: track condition k
  bool big_metal = false, platform = false, slippery = false;
};

struct Model {
  std::vector<Metre> metres = std::vector<Metre>(kMetres);
  std::vector<TemporarySpeedRestriction> tsr;
  std::vector<LevelCrossing> lx;
  std::vector<RouteSuitability> suitability;
  bool inhibited = false;
  struct Authority {
    int end = 0;
    std::optional<int> SvL;  // none: an LOA
    bool shortened = false;
    int far() const { return SvL ? *SvL : end; }
  };
  std::optional<Authority> ma;

  template <class F>
  void each(int from, int to, F f) {
    for (int x = std::max(from, 0); x < std::min(to, kMetres); ++x) f(metres[static_cast<std::size_t>(x)]);
  }
  /// A.3.4: what belongs to an authority is deleted beyond a place; TSR, level crossings and adhesion are not.
  void cut(int at) {
    each(at, kMetres, [](Metre& m) {
      const bool slippery = m.slippery;
      m = Metre{};
      m.slippery = slippery;
    });
    std::erase_if(suitability, [&](const RouteSuitability& s) { return s.at >= testing::at(at); });
  }
  void cut_at_train(int est, int max) {
    if (ma) ma = Authority{std::min(ma->end, est), std::min(ma->far(), max), true};
    cut(max);
  }
};

int whole(Place p) { return static_cast<int>(p.from_origin.si); }

/// Random messages, each into the description and the model.
class Database {
 public:
  explicit Database(unsigned seed) : random_(seed) {}

  /// False: it did not fit, which other tests look at.
  bool run_one_step() {
    front_ += number(0, 40);
    const int doubt = number(1, 9);
    here_ = front_at(front_, doubt, kTrain);
    here_.hole_front = here_.max_safe_front;
    bool fits = true;
    switch (number(0, 13)) {
      case 0:
        stop_conditionally();
        break;
      case 1:
        shorten_at_train();
        break;
      case 2:
        reset();
        break;
      case 3:
        substitute();
        break;
      default:
        fits = receive();
        break;
    }
    (void)advance(description, here_);
    const Place limit = here_.min_safe_rear - Distance{300};
    std::erase_if(model.lx, [&](const LevelCrossing& l) { return l.to < limit; });
    return fits;
  }

  void compare() const {
    compare_speeds();
    compare_conditions();
    compare_authority();
  }

  Description description;
  Model model;
  int accepted = 0, refused = 0, shortened = 0;

 private:
  int number(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
  bool one_in(int n) { return number(1, n) == 1; }
  SpeedCode speed() { return static_cast<SpeedCode>(number(1, 30)); }

  // --- what trackside may send: each writes into the message, and says what the model becomes when it is stored

  void send_ssp(Contents& c, Model& then, int from) {
    c.ssp = NewStaticSpeedProfile{};
    for (int i = number(1, 5); i > 0; --i, from += number(1, 500)) {
      StaticSpeed e;
      e.V_STATIC = i == 1 && one_in(2) ? kEndOfProfile : speed();
      e.Q_FRONT = one_in(2);
      c.ssp->append(at(from), e);
      then.each(from, kMetres, [&](Metre& m) {
        m.V = e.known() ? e.V_STATIC : kUnknown;
        m.V_front = e.Q_FRONT;
      });
    }
  }
  void send_gradient(Contents& c, Model& then, int from) {
    c.gradient = NewGradientProfile{};
    for (int i = number(1, 5); i > 0; --i, from += number(1, 500)) {
      const int permille = i == 1 && one_in(2) ? kUnknown : number(-30, 30);
      c.gradient->append(
          at(from), Gradient{static_cast<std::int16_t>(permille == kUnknown ? int{Gradient::kUnknown} : permille)});
      then.each(from, kMetres, [&](Metre& m) { m.permille = permille; });
    }
  }
  /// Areas one after another, or the initial state from a place on (Q_TRACKINIT).
  template <class T, class Fill, class Clear, class Set>
  void send_areas(std::optional<Fresh<T>>& fresh, Model& then, int from, Clear clear, Fill fill, Set set) {
    fresh = Fresh<T>{};
    fresh->from = at(from);
    fresh->initial_state = one_in(5);
    then.each(from, kMetres, clear);
    if (fresh->initial_state) return;
    for (int i = number(1, 4); i > 0; --i) {
      T area;
      area.from = at(from);
      const int to = from + number(1, 300);
      area.to = at(to);
      fill(area);
      EXPECT_TRUE(fresh->elements.push_back(area));
      then.each(from, to, [&](Metre& m) { set(m, area); });
      from = to + number(0, 200);
    }
  }
  void send_axle_loads(Contents& c, Model& then, int from) {
    send_areas(
        c.asp, then, from, [](Metre& m) { m.axle = kNone; },
        [&](AxleLoadRestriction& a) {
          a.Q_FRONT = one_in(2);
          a.V_AXLELOAD[0] = speed();
        },
        [](Metre& m, const AxleLoadRestriction& a) {
          m.axle = a.V_AXLELOAD[0];
          m.axle_front = a.Q_FRONT;
        });
  }
  void send_braking_distances(Contents& c, Model& then, int from) {
    send_areas(
        c.pbd, then, from, [](Metre& m) { m.pbd = kNone; },
        [&](PermittedBrakingDistance& a) { a.gradient_permille = speed(); },
        [](Metre& m, const PermittedBrakingDistance& a) { m.pbd = static_cast<SpeedCode>(a.gradient_permille); });
  }
  void send_conditions(Contents& c, Model& then, int from) {
    send_areas(
        c.conditions, then, from, [](Metre& m) { m.kinds = 0; },
        [&](TrackCondition& a) { a.kind = static_cast<TrackConditionKind>(number(0, 9)); },
        [](Metre& m, const TrackCondition& a) { m.kinds |= 1u << static_cast<unsigned>(a.kind); });
  }
  void send_big_metal(Contents& c, Model& then, int from) {
    send_areas(
        c.big_metal, then, from, [](Metre& m) { m.big_metal = false; }, [](BigMetalMass&) {},
        [](Metre& m, const BigMetalMass&) { m.big_metal = true; });
  }
  void send_platforms(Contents& c, Model& then, int from) {
    send_areas(
        c.platforms, then, from, [](Metre& m) { m.platform = false; }, [](Platform&) {},
        [](Metre& m, const Platform&) { m.platform = true; });
  }
  void send_adhesion(Contents& c, Model& then, int from) {
    AdhesionArea area;
    area.from = at(from);
    area.to = at(from + number(1, 300));
    area.slippery = one_in(2);
    c.adhesion = area;
    then.each(from, kMetres, [](Metre& m) { m.slippery = false; });
    if (area.slippery) then.each(from, whole(area.to), [](Metre& m) { m.slippery = true; });
  }
  void send_restriction(Contents& c, Model& then, int from) {
    auto t = tsr_of(static_cast<std::uint8_t>(one_in(4) ? 255 : number(0, 4)), from, from + number(0, 400), speed(),
                    one_in(2));
    t.Q_FRONT = one_in(2);
    EXPECT_TRUE(c.tsr.push_back(t));
    if (t.NID_TSR != 255 && !t.from_rbc && then.inhibited) return;
    if (t.NID_TSR != 255)
      std::erase_if(then.tsr, [&](const TemporarySpeedRestriction& old) { return old.NID_TSR == t.NID_TSR; });
    then.tsr.push_back(t);
  }
  void revoke_restriction(Contents& c, Model& then) {
    const auto id = static_cast<std::uint8_t>(one_in(6) ? 255 : number(0, 4));
    EXPECT_TRUE(c.revoked_tsr.push_back(id));
    if (id != 255) std::erase_if(then.tsr, [&](const TemporarySpeedRestriction& old) { return old.NID_TSR == id; });
  }
  void send_level_crossing(Contents& c, Model& then, int from) {
    LevelCrossing lx;
    lx.NID_LX = static_cast<std::uint8_t>(number(0, 3));
    lx.from = at(from);
    lx.to = at(from + number(1, 60));
    lx.unprotected = one_in(2);
    lx.V_LX = speed();
    EXPECT_TRUE(c.lx.push_back(lx));
    for (const LevelCrossing& old : then.lx)
      if (old.NID_LX == lx.NID_LX && lx.unprotected && here_.min_safe_front <= old.to) {  // else passed: another one
        lx.substituted = old.substituted;
        lx.V_LX_from = old.V_LX_from;
      }
    std::erase_if(then.lx, [&](const LevelCrossing& old) { return old.NID_LX == lx.NID_LX; });
    then.lx.push_back(lx);
  }
  void send_suitability(Contents& c, Model& then, int from) {
    c.suitability = Fresh<RouteSuitability>{};
    c.suitability->from = at(from);
    if (one_in(4)) {
      c.suitability->initial_state = true;
      std::erase_if(then.suitability, [&](const RouteSuitability& s) { return s.at >= testing::at(from); });
      return;
    }
    for (int i = number(1, 3); i > 0; --i, from += number(1, 300)) {
      RouteSuitability s;
      s.at = at(from);
      s.kind = static_cast<Suitability>(number(0, 2));
      s.M_LINEGAUGE = static_cast<std::uint8_t>(number(0, 15));
      s.M_LINEAXLELOADCAT = static_cast<std::uint16_t>((2u << number(0, 12)) - 1u);
      s.M_VOLTAGE = static_cast<std::uint8_t>(number(1, 2));
      EXPECT_TRUE(c.suitability->elements.push_back(s));
    }
    for (const RouteSuitability& s : c.suitability->elements)
      std::erase_if(then.suitability, [&](const RouteSuitability& old) { return old.kind == s.kind; });
    for (const RouteSuitability& s : c.suitability->elements) then.suitability.push_back(s);
  }
  MovementAuthority random_authority(int from) {
    MovementAuthority ma = authority_to(std::max(from, front_) + number(50, 1500), from);
    const double end = ma.end().from_origin.si;
    ma.level_1 = one_in(2);
    if (one_in(5)) ma.V_LOA = speed_of(speed());
    if (one_in(3)) ma.danger_point = DangerPoint{at(end + number(0, 90)), {}};
    if (one_in(4)) ma.overlap = Overlap{at(end), at(end + number(0, 90)), {}, {}};
    return ma;
  }

  bool known(const Model& m, int from, int to) const {
    for (int x = from; x < to; ++x) {
      const Metre& metre = m.metres[static_cast<std::size_t>(x)];
      if (metre.V == kUnknown || metre.permille == kUnknown) return false;
    }
    return true;
  }

  /// One message: its data are written into a copy of the model (`together`), to know whether they describe its
  /// authority (3.7.2.3), and again after what the authority deletes.
  bool receive() {
    Contents c;
    c.medium = Medium::rbc;
    const std::mt19937 before = random_;
    const int from = front_ - number(0, 60);
    const auto write = [&](Model& then) {
      random_ = before;
      c = Contents{};
      c.medium = Medium::rbc;
      (void)number(0, 60);
      if (one_in(3)) c.infill = at(front_ + number(0, 200));
      const int start = c.infill ? whole(*c.infill) : from;
      if (one_in(2)) c.ma = random_authority(start);
      if (!one_in(4)) send_ssp(c, then, start + (one_in(4) ? number(-20, 200) : 0));
      if (!one_in(4)) send_gradient(c, then, start + (one_in(4) ? number(-20, 200) : 0));
      if (one_in(4)) send_axle_loads(c, then, start + number(0, 400));
      if (one_in(4)) send_braking_distances(c, then, start + number(0, 400));
      if (one_in(3)) send_conditions(c, then, start + number(0, 400));
      if (one_in(4)) send_big_metal(c, then, start + number(0, 400));
      if (one_in(4)) send_platforms(c, then, start + number(0, 400));
      if (one_in(4)) send_adhesion(c, then, start + number(0, 400));
      if (one_in(6)) revoke_restriction(c, then);
      if (one_in(20)) c.inhibit_revocable_tsr = then.inhibited = true;
      if (one_in(3)) send_restriction(c, then, start + number(0, 800));
      if (one_in(4)) send_level_crossing(c, then, start + number(0, 800));
      if (one_in(5)) send_suitability(c, then, start + number(0, 1500));
      if (one_in(5)) c.V_MAIN = speed();
    };
    Model together = model;
    write(together);
    take_authority(c, together);
    if (c.V_MAIN) take_signalling_speed(*c.V_MAIN, c.infill);
    write(model);
    const Stored stored = store(description, c, here_);
    EXPECT_EQ(stored.ma_accepted, expected_accepted_);
    accepted += stored.ma_accepted;
    refused += stored.ma_refused;
    shortened += stored.shortened;
    for (const Note& note : stored.notes)
      if (note.what == Note::What::full) return false;
    return true;
  }

  void take_authority(const Contents& c, const Model& together) {
    expected_accepted_ = false;
    if (!c.ma) return;
    const MovementAuthority& ma = *c.ma;
    const int end = whole(ma.end());
    Model::Authority fresh{end, end, false};
    if (ma.danger_point) fresh.SvL = whole(ma.danger_point->at);
    if (ma.overlap) fresh.SvL = whole(ma.overlap->end);  // it comes before a danger point (3.8.4.5)
    if (ma.limited()) fresh.SvL.reset();
    if (c.infill && !model.ma) return;
    if (c.infill && model.ma->far() + (model.ma->shortened ? 0 : 22) < whole(*c.infill)) return;  // 3.8.5.1 b
    if (!known(together, c.infill ? whole(*c.infill) : front_, fresh.far())) return;
    expected_accepted_ = true;
    const std::optional<Model::Authority> old = model.ma;
    model.ma = fresh;
    if (old && fresh.SvL && (!old->SvL || *fresh.SvL < *old->SvL)) model.cut(fresh.far());  // 3.8.5.1.3, .4
    if (!ma.level_1) model.each(0, kMetres, [](Metre& m) { m.signalling = kNone; });        // 3.11.6.3.1
  }
  void take_signalling_speed(SpeedCode V_MAIN, const std::optional<Place>& infill) {
    if (!infill) model.each(0, kMetres, [](Metre& m) { m.signalling = kNone; });
    model.each(infill ? whole(*infill) : whole(here_.min_safe_rear - Distance{300.0}), kMetres,
               [&](Metre& m) { m.signalling = V_MAIN; });
  }

  // --- what takes data away

  void stop_conditionally() {  // 3.10.2.2 of 4.0.0, A.3.4 a
    const int stop = front_ + number(0, 1200);
    (void)stop_at(description, at(stop), here_);
    if (model.ma) {
      Model::Authority& ma = *model.ma;
      if (stop <= ma.end)
        ma = {stop, stop, true};
      else if (!ma.SvL)
        ma = {ma.end, ma.end, true};
      else if (stop <= *ma.SvL)
        ma = {ma.end, stop, true};
    }
    model.cut(stop);
  }
  void shorten_at_train() {  // A.3.4 e, g to j, l, m
    constexpr std::array kinds{Situation::e_end_section_timeout, Situation::h_linking_reaction,
                               Situation::i_radio_contact_lost, Situation::j_train_data_changed};
    (void)shorten(description, kinds[static_cast<std::size_t>(number(0, 3))], {}, here_);
    model.cut_at_train(front_, whole(here_.max_safe_front));
  }
  void reset() {  // rows of 4.10, and A.3.4 k
    switch (number(0, 7)) {
      case 0:
        (void)shorten(description, Situation::k_desk_closed_during_start, {}, here_);
        model = Model{};
        break;
      case 1:
        (void)forget(description, evc::Stored::movement_authority);
        model.ma.reset();
        break;
      case 2:
        (void)forget(description, evc::Stored::ssp);
        model.each(0, kMetres, [](Metre& m) { m.V = kUnknown; });
        break;
      case 3:
        (void)forget(description, evc::Stored::tsr);
        (void)forget(description, evc::Stored::inhibit_revocable_tsr);
        model.tsr.clear();
        model.inhibited = false;
        break;
      case 4:
        (void)forget(description, evc::Stored::track_conditions_general);
        model.each(0, kMetres, [](Metre& m) {
          for (unsigned k = 0; k < 10; ++k)
            if (!horn_or_stopping(static_cast<TrackConditionKind>(k))) m.kinds &= ~(1u << k);
          m.platform = false;
        });
        break;
      case 5:
        (void)forget(description, evc::Stored::gradient);
        model.each(0, kMetres, [](Metre& m) { m.permille = kUnknown; });
        break;
      case 6:
        (void)forget(description, evc::Stored::asp);
        model.each(0, kMetres, [](Metre& m) { m.axle = kNone; });
        break;
      default:
        (void)forget(description, evc::Stored::level_crossing);
        model.lx.clear();
        break;
    }
  }
  void substitute() {  // 5.16
    const auto id = static_cast<std::uint8_t>(number(0, 3));
    substitute_level_crossing(description, id, at(front_));
    for (LevelCrossing& lx : model.lx)
      if (lx.NID_LX == id && lx.unprotected && !lx.substituted) {
        lx.substituted = true;
        lx.V_LX_from = at(front_);
      }
  }

  // --- comparison

  Speed speed_at(int x) const {
    SpeedCode least = kNoSpeed;
    const auto take = [&](int code) {
      if (code >= 0 && code < least) least = static_cast<SpeedCode>(code);
    };
    // A speed is left when the rear end has left it (3.11.3.1.3).
    for (int y = std::max(0, x - kTrain); y <= x; ++y) {
      const Metre& m = model.metres[static_cast<std::size_t>(y)];
      if (m.V != kUnknown && (y == x || !m.V_front)) take(m.V);
      if (m.axle != kNone && (y == x || !m.axle_front)) take(m.axle);
    }
    const Metre& m = model.metres[static_cast<std::size_t>(x)];
    if (m.pbd != kNone) take(m.pbd);
    if (m.signalling != kNone) take(m.signalling);
    for (const TemporarySpeedRestriction& t : model.tsr)
      if (x >= whole(t.from) && x < whole(t.to) + (t.Q_FRONT ? 0 : kTrain)) take(t.V_TSR);
    for (const LevelCrossing& lx : model.lx)
      if (lx.unprotected && lx.substituted && x >= whole(lx.V_LX_from) && x < whole(lx.to)) take(lx.V_LX);
    return least == kNoSpeed ? kNoLimit : speed_of(least);
  }
  void compare_speeds() const {
    MrspQuery q;
    q.from = here_.min_safe_rear - Distance{100};
    q.train_length = Distance{kTrain};
    InplaceVector<SpeedCode, 40> pbd_speeds;
    for (const PermittedBrakingDistance& a : description.pbd)
      ASSERT_TRUE(pbd_speeds.push_back(static_cast<SpeedCode>(a.gradient_permille)));
    q.pbd_speeds = {pbd_speeds.begin(), pbd_speeds.size()};
    const Mrsp f = testing::mrsp(description, q);
    const GradientFunction g = testing::gradient(description, q.from);
    for (int x = std::max(0, whole(q.from)); x < kMetres; ++x) {
      const Place middle = at(x + 0.5);
      ASSERT_EQ(f.at(middle), speed_at(x)) << "MRSP at " << x << " m";
      const int permille = model.metres[static_cast<std::size_t>(x)].permille;
      ASSERT_EQ(g.at(middle), permille == kUnknown ? 0.0 : permille) << "gradient at " << x << " m";
    }
  }
  void compare_conditions() const {
    Model shown;
    for (const TrackCondition& a : description.conditions)
      shown.each(whole(a.from), whole(a.to), [&](Metre& m) { m.kinds |= 1u << static_cast<unsigned>(a.kind); });
    for (const BigMetalMass& a : description.big_metal)
      shown.each(whole(a.from), whole(a.to), [](Metre& m) { m.big_metal = true; });
    for (const Platform& a : description.platforms)
      shown.each(whole(a.from), whole(a.to), [](Metre& m) { m.platform = true; });
    for (const AdhesionArea& a : description.adhesion)
      shown.each(whole(a.from), whole(a.to), [](Metre& m) { m.slippery = true; });
    // Data beyond 300 m behind the rear end are deleted, and that end wavers with the interval.
    for (int x = std::max(0, whole(here_.min_safe_rear) - 280); x < kMetres; ++x) {
      const Metre& is = shown.metres[static_cast<std::size_t>(x)];
      const Metre& expected = model.metres[static_cast<std::size_t>(x)];
      ASSERT_EQ(is.kinds, expected.kinds) << "conditions at " << x << " m";
      ASSERT_EQ(is.big_metal, expected.big_metal) << "big metal mass at " << x << " m";
      ASSERT_EQ(is.platform, expected.platform) << "platform at " << x << " m";
      ASSERT_EQ(is.slippery, expected.slippery) << "adhesion at " << x << " m";
    }
  }
  static bool closed(const RouteSuitability& s) {
    if (s.kind == Suitability::gauge) return (s.M_LINEGAUGE & 2u) == 0;
    if (s.kind == Suitability::axle_load) return (s.M_LINEAXLELOADCAT & 32u) == 0;
    return s.M_VOLTAGE != 1;
  }
  void compare_authority() const {
    TrainInterfaces train;
    train.M_LOADINGGAUGE = 2;
    train.M_AXLELOADCAT = 5;
    ASSERT_TRUE(train.tractions.push_back({1, 0}));
    const Authority is = authority(description, train, Mode::FS, here_.est_front);
    std::optional<int> stop;
    const auto stop_at = [&](Place place) { stop = stop ? std::min(*stop, whole(place)) : whole(place); };
    for (const RouteSuitability& s : model.suitability)
      if (closed(s)) stop_at(s.at);
    for (const LevelCrossing& lx : model.lx)
      if (lx.unprotected && !lx.substituted) stop_at(lx.from);
    std::optional<int> EOA, SvL, LOA;
    if (model.ma && !model.ma->SvL && (!stop || *stop > model.ma->end)) {
      LOA = model.ma->end;
    } else if (model.ma) {
      EOA = stop ? std::min(model.ma->end, *stop) : model.ma->end;
      SvL = model.ma->SvL && stop ? std::min(*model.ma->SvL, *stop) : model.ma->SvL ? model.ma->SvL : stop;
    }
    const auto place = [](const std::optional<int>& x) { return x ? std::optional(at(*x)) : std::nullopt; };
    ASSERT_EQ(is.EOA, place(EOA));
    ASSERT_EQ(is.SvL, place(SvL));
    ASSERT_EQ(is.LOA, place(LOA));
  }

  std::mt19937 random_;
  int front_ = 400;
  bool expected_accepted_ = false;
  Here here_;
};

/// EVC_CASES random databases, 300 without it.
unsigned databases() {
  const char* cases = std::getenv("EVC_CASES");  // NOLINT(concurrency-mt-unsafe)
  return cases != nullptr ? static_cast<unsigned>(std::strtoul(cases, nullptr, 10)) : 300;
}

TEST(Metres, TheDescriptionEqualsAModelOfEveryMetre) {
  int accepted = 0, refused = 0, shortened = 0, full = 0;
  const unsigned count = databases();
  for (unsigned seed = 0; seed < count; ++seed) {
    Database database(seed);
    for (int step = 0; step < 25; ++step) {
      if (!database.run_one_step()) {
        ++full;
        break;
      }
      if (step % 3 == 0) database.compare();
      if (HasFailure()) FAIL() << "seed " << seed << ", step " << step;
    }
    accepted += database.accepted;
    refused += database.refused;
    shortened += database.shortened;
  }
  EXPECT_GT(accepted, static_cast<int>(count));
  EXPECT_GT(refused, static_cast<int>(count));
  EXPECT_GT(shortened, static_cast<int>(count) / 4);
  EXPECT_LT(full, static_cast<int>(count) / 20);
}

}  // namespace
}  // namespace evc::track
