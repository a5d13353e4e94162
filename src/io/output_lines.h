#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "io/display_json.h"
#include "kernel/evc.h"

namespace evc::io {

/// The names of national systems by NID_NTC.
using NationalSystemNames = std::map<std::uint8_t, std::string>;

/// Appends one line of `evc-state/1`: speeds in km/h, places in metres of the nominal counter, both
/// rounded to a millionth; the same bytes on every machine.
/// `planning`: the advance display, null where there is none or it is not asked for; `dmi`: the record of the display,
/// null where it is not asked for, with the `sounds` of the display since the line before. Texts have the names of
/// `names`.
void append_output(std::string& out, std::int64_t t_ms, const kernel::Outputs& outputs,
                   const kernel::Planning* planning = nullptr, const NationalSystemNames& names = {},
                   const kernel::Display* dmi = nullptr, std::span<const NamedSound> sounds = {});

/// The same as one row of comma separated values, nested keys joined with a dot; lists are joined
/// with a semicolon in one quoted field.
void append_trace(std::string& out, std::int64_t t_ms, const kernel::Outputs& outputs);
/// The header row of the trace.
std::string trace_header();

/// As texts::line_of.
void append_event(std::string& out, const kernel::Event& event);

/// Whether anything other than position and speed differs (`--changes`): events, messages and
/// radio orders of the cycle count as differences.
bool differ_beyond_motion(const kernel::Outputs& a, const kernel::Outputs& b);
/// The same of advance displays; null: there is none.
bool differ_beyond_motion(const kernel::Planning* a, const kernel::Planning* b);

}  // namespace evc::io
