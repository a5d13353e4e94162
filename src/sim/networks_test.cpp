#include "sim/networks.h"

#include <gtest/gtest.h>

#include <memory>

namespace evc::sim {
namespace {

/// SUBSET-026-3 3.5.6: registered are the terminals some time after the order for a network that is there.
TEST(Terminals, RegisterWithTheNetworkAlongTheLineAlone) {
  Networks networks;
  networks.along_line = 0x26201F;
  Terminals terminals(networks);
  const auto outputs = std::make_unique<port::Outputs>();
  const auto registered_after = [&](std::uint32_t NID_MN, std::int64_t t_ms) {
    outputs->radio_register = NID_MN;
    terminals.hear(*outputs, t_ms);
    outputs->radio_register.reset();
    std::optional<std::int64_t> after_ms;
    for (std::int64_t passed_ms = 100; passed_ms <= 60000 && !after_ms; passed_ms += 100) {
      terminals.hear(*outputs, t_ms + passed_ms);
      if (terminals.registered(t_ms + passed_ms)) after_ms = passed_ms;
    }
    return after_ms;
  };
  EXPECT_FALSE(terminals.registered(3600'000)) << "nobody has ordered it";
  EXPECT_EQ(registered_after(0x26201F, 0), 4000);
  EXPECT_EQ(registered_after(0x26202F, 100'000), std::nullopt) << "another network is not there";
  EXPECT_EQ(registered_after(port::kDefaultNetwork, 200'000), 4000);
}

TEST(Terminals, AreRegisteredWhereNoNetworkIsNamed) { EXPECT_TRUE(Terminals(Networks{}).registered(0)); }

}  // namespace
}  // namespace evc::sim
