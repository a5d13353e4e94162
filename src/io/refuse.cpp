#include "io/refuse.h"

#include <string>

#include "texts/texts.h"

namespace evc::io {
namespace {

/// The key of a fault of train or national values, and the expected value.
struct FaultPlace {
  train::Fault fault;
  const char* key;
  const char* expected;
};
constexpr FaultPlace kFaultPlaces[] = {
    {train::Fault::brake_percentage, "brake_percentage", "30 to 250 %"},
    {train::Fault::train_length_lambda, "length_m", "at most 900 m (PassengerP) or 1500 m (freight) with a percentage"},
    {train::Fault::maximum_speed_lambda, "max_speed_kmh", "at most 200 km/h with a brake percentage"},
    {train::Fault::train_length, "length_m", "1 to 4095 m"},
    {train::Fault::maximum_speed, "max_speed_kmh", "5 to 600 km/h"},
    {train::Fault::traction_cut_off_time, "T_traction_cut_off_s", "0 to 60 s"},
    {train::Fault::antenna, "L_antenna_front_m", "0 m to the train length"},
    {train::Fault::rotating_mass, "M_rotating_nom_pct", "0 to 100 %"},
    {train::Fault::no_emergency_model, "A_brake_emergency", "a model without special brakes"},
    {train::Fault::no_service_model, "A_brake_service", "a model without special brakes"},
    {train::Fault::no_emergency_time, "T_brake_emergency_s", "a time without special brakes"},
    {train::Fault::no_service_time, "T_brake_service_s", "a time without special brakes"},
    {train::Fault::deceleration, "A_brake_emergency", "steps from 0 km/h with 0 to 10 m/s2"},
    {train::Fault::correction_factor, "Kdry_rst", "Kdry_rst and Kwet_rst from 0 to 1"},
    {train::Fault::build_up_time, "T_brake_emergency_s", "build-up times not shorter than the reaction times"},
    {train::Fault::Kn, "Kn_plus", "0 to 10 m/s2"},
    {train::Fault::guidance_without_model, "A_brake_normal_service", "three models or none"},
    {train::Fault::special_brake_interface, "special_brakes", "an interface that exists for this brake"},
    {train::Fault::Kv_int, "Kv_int_passenger", "Kv_int from 0 to 2.54"},
    {train::Fault::Kr_int, "Kr_int", "0 to 1.55"},
    {train::Fault::Kt_int, "Kt_int", "0 to 1.55"},
    {train::Fault::A_NVP, "A_NVP12", "A_NVP12 not above A_NVP23"},
    {train::Fault::M_NVAVADH, "M_NVAVADH", "0 to 1"},
    {train::Fault::M_NVEBCL, "M_NVEBCL", "0 to 9"},
    {train::Fault::A_NVMAXREDADH, "A_NVMAXREDADH1", "A_NVMAXREDADH from 0 to 3.15 m/s2"},
};

/// The expected value with its clause.
std::string expected_for(train::Fault fault) {
  std::string expected = "a value in range";
  for (const FaultPlace& f : kFaultPlaces)
    if (f.fault == fault) expected = f.expected;
  return expected + of_clause(train::clause(fault));
}

}  // namespace

void refuse(const JsonPlace& place, train::Fault fault) {
  if (fault == train::Fault::none) return;
  for (const FaultPlace& f : kFaultPlaces) {
    if (f.fault != fault) continue;
    if (const auto key = place.find(f.key)) key->fail(expected_for(fault));
    place.fail(std::string("no usable ") + f.key, expected_for(fault));
  }
  place.fail(texts::name(fault), expected_for(fault));
}

double number_or(const JsonPlace& place, double least, double most, train::Fault fault) {
  const double v = place.number();
  if (!(v >= least && v <= most)) place.fail(expected_for(fault));
  return v;
}

}  // namespace evc::io
