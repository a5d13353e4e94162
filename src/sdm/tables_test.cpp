// The tables of 3.13.10 equal the reference facts, row by row.
#include "sdm/tables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sdm/test_tables.h"

namespace {

using evc::Monitoring;
using evc::Status;
using namespace evc::sdm;
using namespace evc::sdm::test;

template <class Enum, std::size_t N>
const char* name(Enum value, const char* const (&names)[N]) {
  const auto i = static_cast<std::size_t>(value);
  return i < N ? names[i] : "?";
}
std::string text(Bound b) {
  return name(
      b, {"none", "Vt", "Vt+dVw(Vt)", "Vt+dVsbi(Vt)", "Vt+dVebi(Vt)", "M", "M+dVw(M)", "M+dVsbi(M)", "M+dVebi(M)"});
}
std::string text(Limit l) { return name(l, {"-", "dI(V)", "dP(V)", "dW(V)", "dSBI(V)", "dEBI(V)", "dI(M)"}); }
std::string text(Command c) { return name(c, {"-", "TCO", "SB", "EB"}); }
std::string text(Status s) { return name(s, {"-", "NoS", "IndS", "OvS", "WaS", "IntS"}); }
std::string text(EbRelease e) { return name(e, {"never", "always", "if_permitted", "or_zero"}); }
std::string text(Monitoring m) { return name(m, {"-", "CSM", "TSM", "RSM"}); }

std::string between(Bound above, Bound upto) {
  if (above == Bound::none) return "V<=" + text(upto);
  if (upto == Bound::none) return "V>" + text(above);
  return text(above) + "<V<=" + text(upto);
}
std::string speed(const TriggerRow& r) {
  if (r.equal) return "V=" + text(r.above) + (r.upto == Bound::none ? "" : " and " + text(r.upto));
  return between(r.above, r.upto);
}
std::string speed(const RevocationRow& r) {
  if (r.standstill && r.above == Bound::none && r.upto == Bound::none) return "standstill";
  return between(r.above, r.upto) + (r.standstill ? " and standstill" : "");
}

std::string line(const TriggerRow& r) {
  return "t" + std::to_string(r.id) + ": " + speed(r) + ", beyond " + text(r.beyond) + ", not beyond " +
         text(r.not_beyond) + ": " + text(r.command) + ", " + text(r.status);
}
std::string line(const RevocationRow& r) {
  return "r" + std::to_string(r.id) + ": " + speed(r) + ", not beyond " + text(r.not_beyond) + ": TCO " +
         std::to_string(r.TCO) + ", SB " + std::to_string(r.SB) + ", EB " + text(r.EB) + ", to " + text(r.to);
}
std::string line(const TransitionRow& r) {
  return text(r.from) + " to " + text(r.to) + " by " + std::to_string(r.conditions);
}
template <class Row>
std::vector<std::string> lines(std::span<const Row> rows) {
  std::vector<std::string> all;
  for (const Row& r : rows) all.push_back(line(r));
  return all;
}
void expect(const std::vector<std::string>& ours, const std::vector<std::string>& wanted) {
  ASSERT_EQ(ours.size(), wanted.size());
  for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_EQ(ours[i], wanted[i]);
}
void expect_rows(std::span<const TriggerRow> rows, const std::vector<std::string>& wanted) {
  expect(lines(rows), wanted);
}
void expect_rows(std::span<const RevocationRow> rows, const std::vector<std::string>& wanted) {
  expect(lines(rows), wanted);
}
void expect_rows(std::span<const TransitionRow> rows, const std::vector<std::string>& wanted) {
  std::vector<std::string> ours = lines(rows);
  std::sort(ours.begin(), ours.end());  // 3.13.10.6 gives no order
  expect(ours, wanted);
}

TEST(Tables, CeilingSpeedMonitoring) { expect_rows(kCSM, ceiling_triggers()); }
TEST(Tables, ReleaseSpeedMonitoring) { expect_rows(kRSM, release_triggers()); }
TEST(Tables, TargetSpeedMonitoring340) {
  expect_rows(kTSM_MRSP_LOA_3_4_0, triggers_3_4_0(false));
  expect_rows(kTSM_EOA_SvL_3_4_0, triggers_3_4_0(true));
}
TEST(Tables, TargetSpeedMonitoring360) {
  expect_rows(kTSM_MRSP_LOA_3_6_0, triggers_3_6_0(false));
  expect_rows(kTSM_EOA_SvL_3_6_0, triggers_3_6_0(true));
}
TEST(Tables, TargetSpeedMonitoring400) {
  expect_rows(kTSM_MRSP_LOA_4_0_0, triggers_4_0_0(false));
  expect_rows(kTSM_EOA_SvL_4_0_0, triggers_4_0_0(true));
}
TEST(Tables, Revocations) {
  expect_rows(kCSM_revocation, ceiling_revocations());
  expect_rows(kRSM_revocation, release_revocations());
  expect_rows(kTSM_revocation_3_4_0, revocations_3_4_0());
  expect_rows(kTSM_revocation_4_0_0, revocations_4_0_0());
}
TEST(Tables, TransitionsBetweenTypesOfMonitoring) {
  expect_rows(kTransitions_3_4_0, transitions_3_4_0());
  expect_rows(kTransitions_4_0_0, transitions_4_0_0());
}
/// Every issue of the standard has its own tables.
TEST(Tables, ByVersion) {
  using evc::SrsVersion;
  const auto same = [](auto a, auto b) { return a.data() == b.data() && a.size() == b.size(); };
  const Rules v340 = rules_of(SrsVersion::v3_4_0);
  const Rules v360 = rules_of(SrsVersion::v3_6_0);
  const Rules v400 = rules_of(SrsVersion::v4_0_0);
  EXPECT_TRUE(same(trigger_table(v340, false), std::span<const TriggerRow>(kTSM_MRSP_LOA_3_4_0)));
  EXPECT_TRUE(same(trigger_table(v340, true), std::span<const TriggerRow>(kTSM_EOA_SvL_3_4_0)));
  EXPECT_TRUE(same(trigger_table(v360, false), std::span<const TriggerRow>(kTSM_MRSP_LOA_3_6_0)));
  EXPECT_TRUE(same(trigger_table(v360, true), std::span<const TriggerRow>(kTSM_EOA_SvL_3_6_0)));
  EXPECT_TRUE(same(trigger_table(v400, false), std::span<const TriggerRow>(kTSM_MRSP_LOA_4_0_0)));
  EXPECT_TRUE(same(trigger_table(v400, true), std::span<const TriggerRow>(kTSM_EOA_SvL_4_0_0)));
  EXPECT_TRUE(same(revocation_table(v340), std::span<const RevocationRow>(kTSM_revocation_3_4_0)));
  EXPECT_TRUE(same(revocation_table(v360), std::span<const RevocationRow>(kTSM_revocation_4_0_0)));
  EXPECT_TRUE(same(revocation_table(v400), std::span<const RevocationRow>(kTSM_revocation_4_0_0)));
  EXPECT_TRUE(same(transition_table(v340), std::span<const TransitionRow>(kTransitions_3_4_0)));
  EXPECT_TRUE(same(transition_table(v360), std::span<const TransitionRow>(kTransitions_4_0_0)));
  EXPECT_TRUE(same(transition_table(v400), std::span<const TransitionRow>(kTransitions_4_0_0)));
}

}  // namespace
