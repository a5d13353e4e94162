#pragma once
/// A defect of ours, never the world's: `EVC_REQUIRE(cond)` states what the code relies on. When it
/// does not hold the defect is raised: tests install nothing and the process aborts; the kernel
/// traps at the call (`__builtin_trap` needs no library), which the platform maps to system failure
/// and the emergency brake (SUBSET-026-4 4.4.5). Input from outside must be checked before, with a
/// value as the answer.
#define EVC_REQUIRE(cond)          \
  do {                             \
    if (!(cond)) __builtin_trap(); \
  } while (false)
