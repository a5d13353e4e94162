#pragma once
/// `EVC_REQUIRE(cond)` states what the code relies on; a false condition is a defect of the
/// program, never of its input. The program traps at the call (`__builtin_trap` needs no library);
/// the platform has to map this to system failure and the emergency brake (SUBSET-026-4 4.4.5).
/// Input from outside must be checked before, and its errors returned as values.
#define EVC_REQUIRE(cond)          \
  do {                             \
    if (!(cond)) __builtin_trap(); \
  } while (false)
