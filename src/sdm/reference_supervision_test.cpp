// `supervise` compared with the reference supervision: random journeys, with many cycles exactly at a limit.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "sdm/test_journeys.h"
#include "sdm/test_reference_display.h"
#include "sdm/test_reference_supervision.h"
#include "sdm/test_reference_tables.h"

namespace {

using namespace evc;
using namespace evc::sdm;
using namespace evc::sdm::test;

// ---- Comparison -------------------------------------------------------------------------------------

void expect_equal(const Result& a, const Result& b) {
  ASSERT_EQ(a.monitoring, b.monitoring);
  ASSERT_EQ(a.status, b.status);
  ASSERT_EQ(a.tco, b.tco);
  ASSERT_EQ(a.sb, b.sb);
  ASSERT_EQ(a.eb, b.eb);
  ASSERT_EQ(a.highest.monitoring, b.highest.monitoring);
  ASSERT_EQ(a.highest.condition, b.highest.condition);
  ASSERT_EQ(a.status_changed, b.status_changed);
  ASSERT_EQ(a.monitoring_changed, b.monitoring_changed);
  ASSERT_EQ(a.MRDT_changed, b.MRDT_changed);
  ASSERT_EQ(a.V_MRSP, b.V_MRSP);
  ASSERT_EQ(a.V_P, b.V_P);
  ASSERT_EQ(a.V_W, b.V_W);
  ASSERT_EQ(a.V_SBI, b.V_SBI);
  ASSERT_EQ(a.V_EBI, b.V_EBI);
  ASSERT_EQ(a.show_SBI, b.show_SBI);
  ASSERT_EQ(a.V_target, b.V_target);
  ASSERT_EQ(a.d_target, b.d_target);
  ASSERT_EQ(a.MRDT, b.MRDT);
  ASSERT_EQ(a.V_release, b.V_release);
  ASSERT_EQ(a.first_indication, b.first_indication);
  ASSERT_EQ(a.TTI, b.TTI);
  ASSERT_EQ(a.MA_request, b.MA_request);
  ASSERT_EQ(a.truncated, b.truncated);
  ASSERT_EQ(a.no_deceleration, b.no_deceleration);
}

void expect_equal(const Supervision& a, const Supervision& b) {
  ASSERT_EQ(a.active, b.active);
  ASSERT_EQ(a.monitoring, b.monitoring);
  ASSERT_EQ(a.status, b.status);
  ASSERT_EQ(a.tco, b.tco);
  ASSERT_EQ(a.sb, b.sb);
  ASSERT_EQ(a.eb, b.eb);
  ASSERT_EQ(a.eb_for_sb, b.eb_for_sb);
  ASSERT_EQ(a.list_revision, b.list_revision);
  ASSERT_EQ(a.list_passed, b.list_passed);
  ASSERT_EQ(a.has_MRDT, b.has_MRDT);
  if (a.has_MRDT) {
    ASSERT_EQ(a.MRDT, b.MRDT);
  }
  ASSERT_EQ(a.V_MRSP, b.V_MRSP);
  ASSERT_EQ(a.hold_P, b.hold_P);
  ASSERT_EQ(a.hold_SBI, b.hold_SBI);
  ASSERT_EQ(a.hold_target_distance, b.hold_target_distance);
  ASSERT_EQ(a.shown_P, b.shown_P);
  ASSERT_EQ(a.shown_SBI, b.shown_SBI);
  ASSERT_EQ(a.shown_target_distance, b.shown_target_distance);
  ASSERT_EQ(a.feedback.started, b.feedback.started);
  ASSERT_EQ(a.feedback.locked, b.feedback.locked);
  ASSERT_EQ(a.feedback.p0_known, b.feedback.p0_known);
  ASSERT_EQ(a.feedback.p0, b.feedback.p0);
  ASSERT_EQ(a.feedback.searching, b.feedback.searching);
  ASSERT_EQ(a.feedback.T_bs1_previous, b.feedback.T_bs1_previous);
  ASSERT_EQ(a.feedback.approaching, b.feedback.approaching);
}

/// The events of the journeys of a version: the more, the stronger the comparison.
struct Seen {
  int CSM = 0, TSM = 0, RSM = 0, indication = 0, warning = 0, intervention = 0, held = 0, locked = 0, TTI = 0;
};

std::string state(const Journey& j, const Motion& m, const Result& wanted) {
  std::ostringstream text;
  text << "type " << static_cast<int>(wanted.monitoring) << ", status " << static_cast<int>(wanted.status) << ", V "
       << m.V_est.si << ", V_MRSP " << wanted.V_MRSP.si << ", fronts " << m.min_safe_front.from_origin.si << " "
       << m.est_front.from_origin.si << " " << m.max_safe_front.from_origin.si;
  const ReleaseSpeed& release = j.derived->release_speed;
  if (release.exists)
    text << ", release speed " << release.V_release.si << " from " << release.d_SBI1.from_origin.si << " "
         << release.d_SBI2.from_origin.si << ", trip " << release.d_trip.from_origin.si;
  for (const Sight& x : j.reference.list)
    text << "; target " << static_cast<int>(x.t.kind) << " at " << x.t.d_target.from_origin.si << " " << x.t.V_target.si
         << ", I " << x.I() << " P " << x.P() << " W " << x.W() << " SBI " << x.SBI() << ", V_P " << x.V_P().si;
  return text.str();
}

void journeys(SrsVersion srs, std::uint64_t from, int number, Seen& seen, bool dense = false) {
  for (int i = 0; i < number; ++i) {
    Journey j(from + static_cast<std::uint64_t>(i), srs, dense);
    for (int cycle = 0; cycle < 20; ++cycle) {
      const Motion& m = j.next();
      const Result wanted = j.reference.cycle(*j.derived, m);
      SCOPED_TRACE(testing::Message() << "journey " << from + static_cast<std::uint64_t>(i) << ", cycle " << cycle
                                      << ": " << state(j, m, wanted));
      const Result r = supervise(j.s, *j.derived, m);
      ASSERT_NO_FATAL_FAILURE(expect_equal(r, wanted));
      ASSERT_NO_FATAL_FAILURE(expect_equal(j.s, j.reference.s));
      seen.CSM += r.monitoring == Monitoring::CSM;
      seen.TSM += r.monitoring == Monitoring::TSM;
      seen.RSM += r.monitoring == Monitoring::RSM;
      seen.indication += r.first_indication.has_value();
      seen.warning += r.status == Status::Warning;
      seen.intervention += r.sb || r.eb;
      seen.held += j.s.hold_P;
      seen.locked += j.s.feedback.locked;
      seen.TTI += r.TTI.has_value();
    }
  }
}

void expect_all_seen(const Seen& seen, int number, bool first_indication) {
  EXPECT_GT(seen.CSM, number);
  EXPECT_GT(seen.TSM, 4 * number);
  EXPECT_GT(seen.RSM, number / 2);
  EXPECT_GT(seen.warning, number / 4);
  EXPECT_GT(seen.intervention, number);
  EXPECT_GT(seen.held, number / 50);
  EXPECT_GT(seen.locked, number / 20);
  EXPECT_GT(seen.indication, first_indication ? number / 2 : -1);
  EXPECT_GT(seen.TTI, first_indication ? number / 20 : -1);
}

TEST(ReferenceSupervision, Version340) {
  const int number = cases(800);
  Seen seen;
  journeys(SrsVersion::v3_4_0, 1000000, number, seen);
  expect_all_seen(seen, number, false);
}
TEST(ReferenceSupervision, DenseTargets) {
  for (const SrsVersion srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0}) {
    Seen seen;
    journeys(srs, 4000000, cases(800) / 16, seen, true);
    EXPECT_GT(seen.TSM, 100);
  }
}
TEST(ReferenceSupervision, Version360) {
  const int number = cases(800);
  Seen seen;
  journeys(SrsVersion::v3_6_0, 2000000, number, seen);
  expect_all_seen(seen, number, true);
}
TEST(ReferenceSupervision, Version400) {
  const int number = cases(800);
  Seen seen;
  journeys(SrsVersion::v4_0_0, 3000000, number, seen);
  expect_all_seen(seen, number, true);
}

}  // namespace
