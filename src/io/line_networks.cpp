#include "io/line_networks.h"

#include "io/rbc_contact.h"

namespace evc::io {

Result<sim::Networks> read_networks(std::string_view line, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(line, file);
    sim::Networks networks;
    const auto place = JsonPlace(document, file).find("radio_networks");
    if (!place) return networks;
    place->know_only({"offered", "along_line"});
    if (const auto offered = place->find("offered"))
      for (std::size_t i = 0; i < offered->size(); ++i)
        if (!networks.offered.push_back(read_NID_MN((*offered)[i]))) offered->fail("at most 16 networks");
    if (const auto along_line = place->find("along_line")) networks.along_line = read_NID_MN(*along_line);
    return networks;
  });
}

}  // namespace evc::io
