#pragma once
#include <array>

// Headers of telegrams and loop messages, for their JSON (8.4.2, 8.4.3).
namespace evc::io {

struct HeaderField {
  const char* name;
  unsigned bits;
};
inline constexpr std::array<HeaderField, 10> balise_header{{{"Q_UPDOWN", 1},
                                                            {"M_VERSION", 7},
                                                            {"Q_MEDIA", 1},
                                                            {"N_PIG", 3},
                                                            {"N_TOTAL", 3},
                                                            {"M_DUP", 2},
                                                            {"M_MCOUNT", 8},
                                                            {"NID_C", 10},
                                                            {"NID_BG", 14},
                                                            {"Q_LINK", 1}}};
inline constexpr std::array<HeaderField, 5> loop_header{
    {{"Q_UPDOWN", 1}, {"M_VERSION", 7}, {"Q_MEDIA", 1}, {"NID_C", 10}, {"NID_LOOP", 14}}};

}  // namespace evc::io
