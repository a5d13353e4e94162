#include "io/output_data.h"

#include "io/json.h"
#include "io/number.h"
#include "io/rbc_contact.h"
#include "io/train_file.h"

namespace evc::io {
namespace {

void append_kmh_member(std::string& out, const char* key, Speed v) {
  out += key;
  append_micro(out, v.si * 3.6);
}

void append_digits(std::string& out, std::uint32_t packed) {
  out += '"';
  append_packed(out, packed);
  out += '"';
}

void append_SR(std::string& out, const kernel::ShownSR& SR) {
  append_kmh_member(out, "{\"V_sr_kmh\":", SR.V);
  out += ",\"D_sr_m\":";
  if (SR.D)
    append_micro(out, SR.D->si);
  else
    out += "null";
  out += '}';
}

void append_covers(std::string& out, const ShownCovers& covers) {
  out += '[';
  bool first = true;
  for (const kernel::ShownCover& cover : covers) {
    out += first ? "{\"NID_C\":" : ",{\"NID_C\":";
    first = false;
    append_number(out, std::int64_t{cover.NID_C});
    out += ",\"NID_VBCMK\":";
    append_number(out, std::int64_t{cover.NID_VBCMK});
    out += ",\"left_s\":";
    append_micro(out, cover.left.si);
    out += ",\"T_VBC\":";
    append_number(out, std::int64_t{cover.T_VBC});
    out += '}';
  }
  out += ']';
}

/// `append_value` where the datum is known.
template <class AppendValue>
void append_datum(std::string& out, const char* key, DataStatus status, AppendValue append_value) {
  out += out.back() == '{' ? "\"" : ",\"";
  out += key;
  out += "\":{\"value\":";
  if (status == DataStatus::unknown)
    out += "null";
  else
    append_value();
  out += ",\"status\":\"";
  out += terms::kNames<kDataStatusRows>[terms::index(status)];
  out += "\"}";
}

}  // namespace

void append_train_data(std::string& out, const kernel::ShownTrainData& train) {
  out += "{\"length_m\":";
  append_micro(out, train.L_TRAIN.si);
  append_kmh_member(out, ",\"max_speed_kmh\":", train.V_MAXTRAIN);
  out += ",\"brake_percentage\":";
  if (train.brake_percentage)
    append_micro(out, *train.brake_percentage);
  else
    out += "null";
  out += ",\"category\":{\"cant_deficiency_mm\":";
  append_number(out, std::int64_t{train.cant_deficiency_mm});
  out += ",\"other\":[";
  bool first = true;
  for (std::size_t i = 0; i < kOtherCategoryNames.size(); ++i) {
    if (((train.other_categories >> i) & 1u) == 0) continue;
    out += first ? "\"" : ",\"";
    first = false;
    out += kOtherCategoryNames[i];
    out += '"';
  }
  out += "],\"axle_load\":\"";
  out += terms::kNames<kAxleLoadRows>[terms::index(train.axle_load)];
  out += "\",\"loading_gauge\":\"";
  out += terms::kNames<kLoadingGaugeRows>[terms::index(train.loading_gauge)];
  out += train.airtight ? "\",\"airtight\":true}}" : "\",\"airtight\":false}}";
}

void append_data(std::string& out, const kernel::ShownData& d, Level level, const ShownCovers& covers) {
  out += '{';
  append_datum(out, "driver_id", d.driver_id_status, [&] { append_string(out, d.driver_id.view()); });
  append_datum(out, "train_running_number", d.train_running_number_status,
               [&] { append_digits(out, d.train_running_number); });
  append_datum(out, "level", d.level_status, [&] { append_string(out, name(level)); });
  append_datum(out, "rbc", d.rbc_status, [&] { append_contact(out, d.rbc.NID_C, d.rbc.NID_RBC, d.rbc.NID_RADIO); });
  append_datum(out, "train_data", d.train_status, [&] { append_train_data(out, d.train); });
  append_datum(out, "sr", d.SR.status, [&] { append_SR(out, d.SR); });
  append_datum(out, "vbc", DataStatus::valid, [&] { append_covers(out, covers); });
  append_datum(out, "adhesion", DataStatus::valid,
               [&] { out += d.slippery_rail ? "\"slippery rail\"" : "\"non slippery rail\""; });
  append_datum(out, "network", d.network ? DataStatus::valid : DataStatus::unknown,
               [&] { append_string(out, digits_of_NID_MN(*d.network)); });
  out += '}';
}

}  // namespace evc::io
