#pragma once
// For tests: the tables of 3.13.10 in the reference facts, one line for every row.
#include <string>
#include <vector>

namespace evc::sdm::test {

/// "t4: Vt<V<=M, beyond dP(V), not beyond -: TCO, OvS"; EOA: towards EOA and SvL (Vt: V_release there).
std::vector<std::string> ceiling_triggers();
std::vector<std::string> release_triggers();
std::vector<std::string> triggers_3_4_0(bool EOA);
std::vector<std::string> triggers_3_6_0(bool EOA);
std::vector<std::string> triggers_4_0_0(bool EOA);
/// "r3: Vt<V<=M, not beyond dP(V): TCO 1, SB 1, EB if_permitted, to IndS"; EB: never, always, if_permitted, or_zero.
std::vector<std::string> ceiling_revocations();
std::vector<std::string> release_revocations();
std::vector<std::string> revocations_3_4_0();
std::vector<std::string> revocations_4_0_0();
/// "CSM to TSM by 18", bit n for condition [n]; in alphabetical order.
std::vector<std::string> transitions_3_4_0();
std::vector<std::string> transitions_4_0_0();

}  // namespace evc::sdm::test
