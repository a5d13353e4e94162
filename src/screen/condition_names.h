#pragma once
#include <array>
#include <string_view>

#include "terms/picture.h"

// What a case calls the symbols of areas B3 to B5 (015560 8.2.3.5, 8.2.3.8, Table 72).
namespace evc::screen {

struct ConditionName {
  std::string_view words;
  Picture picture;
};

// clang-format off
inline constexpr auto kConditionNames = std::to_array<ConditionName>({
    {"pantograph lowered",                         Picture::TC01},
    {"lower pantograph, automatic",                Picture::TC02},
    {"lower pantograph, driver",                   Picture::TC03},
    {"raise pantograph, automatic",                Picture::TC04},
    {"raise pantograph, driver",                   Picture::TC05},
    {"in neutral section",                         Picture::TC06},
    {"neutral section announcement, automatic",    Picture::TC06},
    {"neutral section announcement, driver",       Picture::TC07},
    {"end of neutral section, automatic",          Picture::TC08},
    {"end of neutral section, driver",             Picture::TC09},
    {"in non stopping area",                       Picture::TC10},
    {"non stopping area announcement",             Picture::TC11},
    {"radio hole",                                 Picture::TC12},
    {"magnetic shoe brake inhibited",              Picture::TC13},
    {"magnetic shoe brake inhibition, automatic",  Picture::TC13},
    {"magnetic shoe brake inhibition, driver",     Picture::TC14},
    {"eddy current brake inhibited",               Picture::TC15},
    {"eddy current brake inhibition, automatic",   Picture::TC15},
    {"eddy current brake inhibition, driver",      Picture::TC16},
    {"regenerative brake inhibited",               Picture::TC17},
    {"regenerative brake inhibition, automatic",   Picture::TC17},
    {"regenerative brake inhibition, driver",      Picture::TC18},
    {"air intake closed",                          Picture::TC19},
    {"close air intake, automatic",                Picture::TC19},
    {"open air intake, automatic",                 Picture::TC20},
    {"close air intake, driver",                   Picture::TC21},
    {"open air intake, driver",                    Picture::TC22},
    {"change to no traction system, automatic",    Picture::TC23},
    {"change to no traction system, driver",       Picture::TC24},
    {"change to AC 25 kV 50 Hz, automatic",        Picture::TC25},
    {"change to AC 25 kV 50 Hz, driver",           Picture::TC26},
    {"change to AC 15 kV 16.7 Hz, automatic",      Picture::TC27},
    {"change to AC 15 kV 16.7 Hz, driver",         Picture::TC28},
    {"change to DC 3 kV, automatic",               Picture::TC29},
    {"change to DC 3 kV, driver",                  Picture::TC30},
    {"change to DC 1.5 kV, automatic",             Picture::TC31},
    {"change to DC 1.5 kV, driver",                Picture::TC32},
    {"change to DC 600/750 V, automatic",          Picture::TC33},
    {"change to DC 600/750 V, driver",             Picture::TC34},
    {"sound horn",                                 Picture::TC35},
    {"level crossing not protected",               Picture::LX01},
});
// clang-format on

}  // namespace evc::screen
