#include "paint/symbols.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "paint/font.h"

// Drawn anew from the look of the standard's bitmaps (ERA_ERTMS_015560 13). ST07, PL37, SM and ATO, which are new in
// 4.0.0, are our own drawings of what they mean.
namespace evc::paint {
namespace {

using dmi::Colour;

constexpr Mark surface(const char* path, Colour colour = Colour::none) {
  return {Mark::Kind::surface, colour, 0.0, path, {}};
}
constexpr Mark line(double width, const char* path, Colour colour = Colour::none) {
  return {Mark::Kind::line, colour, width, path, {}};
}
constexpr Mark letters(const char* text, double x, double y, double height, Colour colour = Colour::none) {
  return {Mark::Kind::letters, colour, height, text, {x, y}};
}

// Levels, 52 x 21: a sleeper for the track's equipment, with the number of the level.
constexpr Mark kBox = line(2, "M5 13 L47 13 L47 19 L5 19 Z");
constexpr Mark kFourBlocks = surface(
    "M4 12 L11 12 L11 20 L4 20 Z M17 12 L24 12 L24 20 L17 20 Z M29 12 L36 12 L36 20 L29 20 Z M41 12 L48 12 L48 20 L41 "
    "20 Z");
constexpr Mark kSixBlocks = surface(
    "M2 14.5 L7.5 14.5 L7.5 19.5 L2 19.5 Z M10.5 14.5 L16 14.5 L16 19.5 L10.5 19.5 Z "
    "M19 14.5 L24.5 14.5 L24.5 19.5 L19 19.5 Z M27.5 14.5 L33 14.5 L33 19.5 L27.5 19.5 Z "
    "M36 14.5 L41.5 14.5 L41.5 19.5 L36 19.5 Z M44.5 14.5 L50 14.5 L50 19.5 L44.5 19.5 Z");
constexpr Mark kBeam = surface("M3 12 L49 12 L49 20 L3 20 Z");
constexpr Mark kLowBeam = surface("M2 14.5 L50 14.5 L50 19.5 L2 19.5 Z");
constexpr Mark kAhead = surface("M3 5.5 L20.5 5.5 L20.5 2 L27.5 7 L20.5 12 L20.5 8.5 L3 8.5 Z");
constexpr std::array kLevel0{letters("0", 26, 10, 9), kBox};
constexpr std::array kLevelNtc{letters("NTC", 26, 16, 11)};
constexpr std::array kLevel1{letters("1", 26, 10, 9), kFourBlocks};
constexpr std::array kLevel2{letters("2", 26, 10, 9), kBeam};
constexpr std::array kLevel3{letters("3", 26, 10, 9), kBeam};
constexpr std::array kTo0{surface("M5 4 L25 4 L25 1 L31 5.5 L25 10 L25 7 L5 7 Z"), letters("0", 43.5, 10, 9), kBox};
constexpr std::array kToNtc{surface("M2 9 L11 9 L11 5.5 L19 10.5 L11 15.5 L11 12 L2 12 Z"),
                            letters("NTC", 36, 14.5, 8)};
constexpr std::array kTo1{kAhead, letters("1", 43, 12.5, 11), kSixBlocks};
constexpr std::array kTo2{kAhead, letters("2", 43, 12.5, 11), kLowBeam};
constexpr std::array kTo3{kAhead, letters("3", 43, 12.5, 11), kLowBeam};

// Modes, 32 x 32.
constexpr Mark kShunter = surface(
    "M3 13 L15 13 L15 7 L26 7 L26 13 L29 13 L29 22 L30 22 L30 21 L31 21 L31 24 L1 24 L1 21 L2 21 L2 22 L3 22 Z");
constexpr Mark kWheels = surface("O 7.5 23.4 3.6 O 24.5 23.4 3.6");
constexpr std::array kShunting{kShunter, kWheels,
                               surface("M5.3 18.5 L9.2 15 L9.2 17.2 L15 17.2 L15 19.8 L9.2 19.8 L9.2 22 Z "
                                       "M26.7 18.5 L22.8 15 L22.8 17.2 L17 17.2 L17 19.8 L22.8 19.8 L22.8 22 Z",
                                       Colour::dark_blue)};
constexpr const char* kMastShape =
    "M11 1 L19 1 L20.5 2.5 L20.5 25.5 L19 27 L16.5 27 L16.5 29 L19.5 29 L19.5 31 L10.5 31 L10.5 29 L13.5 29 L13.5 27 "
    "L11 27 L9.5 25.5 L9.5 2.5 Z";
constexpr const char* kLightShapes = "O 15 6 3.6 O 15 14 3.6 O 15 22 3.6";
constexpr Mark kMast = surface(kMastShape);
constexpr Mark kLights = surface(kLightShapes, Colour::dark_blue);
constexpr std::array kOverride{kMast, kLights, surface("M1 14 L8 14 L8 18 L4.5 18 Z"),
                               surface("M22 14 L24.5 14 L24.5 10 L30.5 16 L24.5 22 L24.5 18 L22 18 Z")};
constexpr std::array kTrip{surface("M0 0 L32 0 L32 32 L0 32 Z", Colour::grey), surface(kMastShape, Colour::red),
                           surface(kLightShapes, Colour::grey)};
constexpr std::array kSignal{kMast, kLights};
constexpr std::array kOnSight{line(2.3, "M29.5 3 L3.5 16 L29.5 29"),
                              surface("M23.6 6.5 C 28.4 9.5 28.4 22.5 23.6 25.5 C 18.8 22.5 18.8 9.5 23.6 6.5 Z")};
constexpr Mark kMovementFrame = line(2, "M4 4 L29 4 L29 29 L4 29 Z");
constexpr const char* kEye = "M5.5 16.5 C 11 7.5 22 7.5 27.5 16.5 C 22 25.5 11 25.5 5.5 16.5 Z";
constexpr std::array kStaffResponsible{kMovementFrame, line(2, "M4.5 4.5 L28.5 28.5 M28.5 4.5 L4.5 28.5"),
                                       line(2, "O 16.5 16.5 7"), line(2, kEye)};
constexpr std::array kFullSupervision{kMovementFrame, line(2.3, kEye)};
constexpr std::array kNonLeading{
    line(2.2, "M1.1 3 L5 3 L13 11 L13 21.5 L7 27.5 M30.9 3 L27 3 L19 11 L19 21.5 L25 27.5"),
    surface("M2 8 L3.5 8 L8 12.5 L8 14 L2 14 Z M30 8 L28.5 8 L24 12.5 L24 14 L30 14 Z"),
    surface("O 4.3 26.6 3.4 O 27.7 26.6 3.4"), surface("M13 17 L19 17 L19 21 L13 21 Z")};
constexpr std::array kStandBy{line(2.9, "A 16 17.2 12 27 333"), surface("M14 1 L18 1 L18 13 L14 13 Z")};
constexpr std::array kReversing{line(2.2, "M16 3 L21 3 L29 11 L29 22.5 L23 28.5"),
                                surface("M18 8 L19.5 8 L24 12.5 L24 14 L18 14 Z"), surface("O 20 26.8 3.7"),
                                surface("M1 15 L7 9 L7 12 L16 12 L11.5 17 L7 17 L7 21 Z")};
constexpr std::array kUnfitted{line(1.4, "M1.5 28 L22.5 5.5 M12.5 28 L29 5.5"),
                               line(1.2,
                                    "M21.5 5.5 L30 5.5 M19 8.5 L27.5 8.5 M15 12.5 L24.5 12.5 "
                                    "M11 16.5 L21.5 16.5 M7 20.5 L18.5 20.5 M2 25.5 L14.5 25.5")};
constexpr std::array kSystemFailure{
    surface("M0 0 L32 0 L32 32 L0 32 Z", Colour::grey), surface("M16 1.5 L31 30.5 L1 30.5 Z", Colour::red),
    surface("M14 10 L18 10 L18 22 L14 22 Z M14 24.5 L18 24.5 L18 28 L14 28 Z", Colour::grey)};
constexpr std::array kNationalSystem{
    line(3.6, "M12.7 4 L18.3 4 L27 12.7 L27 18.3 L18.3 27 L12.7 27 L4 18.3 L4 12.7 Z")};
constexpr std::array kLimitedSupervision{
    kMovementFrame,
    surface("M6 6 L10 6 L10 10 L6 10 Z M23 6 L27 6 L27 10 L23 10 Z M6 23 L10 23 L10 27 L6 27 Z "
            "M23 23 L27 23 L27 27 L23 27 Z"),
    surface("M5 16.5 C 11 6.5 22 6.5 28 16.5 C 22 26.5 11 26.5 5 16.5 Z"),
    surface("M15 10.2 L18 10.2 L18 13 L15 13 Z M15 15 L18 15 L18 18 L15 18 Z M15 20 L18 20 L18 22.8 L15 22.8 Z",
            Colour::dark_blue)};
constexpr std::array kAutomaticDriving{line(2.7, "M3.7 30 L16 3.8 L28.3 30")};
constexpr std::array kSupervisedManoeuvre{
    line(2.4,
         "M1.2 16.5 C 7.5 8 11.5 5.2 16 5.2 C 20.5 5.2 24.5 8 30.8 16.5 C 24.5 25 20.5 27.8 16 27.8 "
         "C 11.5 27.8 7.5 25 1.2 16.5 Z"),
    surface("M8 13 L15 13 L15 10 L21 10 L21 13 L24 13 L24 18 L26 18 L26 20 L6 20 L6 18 L8 18 Z"),
    surface("O 12 19.8 2.1 O 20 19.8 2.1"),
    surface("M8.8 16 L11.5 13.7 L11.5 15.2 L15 15.2 L15 16.8 L11.5 16.8 L11.5 18.3 Z "
            "M23.2 16 L20.5 13.7 L20.5 15.2 L17 15.2 L17 16.8 L20.5 16.8 L20.5 18.3 Z",
            Colour::dark_blue)};

// Statuses, 52 x 21.
constexpr std::array kBrake{
    surface("M2 1 L6 1 L6 20 L2 20 Z M46 1 L50 1 L50 20 L46 20 Z", Colour::grey),
    surface("M6 1 L46 1 L46 20 L6 20 Z", Colour::red), line(2.6, "A 26 10.5 11.6 43 137", Colour::grey),
    line(2.6, "A 26 10.5 11.6 223 317", Colour::grey),
    surface("M17.5 1 L34.5 1 L34.5 2.3 L17.5 2.3 Z M17.5 18.7 L34.5 18.7 L34.5 20 L17.5 20 Z", Colour::grey)};
constexpr std::array kSlippery{line(2, "O 25.5 8 6.9"), line(1.4, "M9 15.5 L42 15.5"),
                               surface("M6.8 15.5 L11 12 L11 18 Z M44.2 15.5 L40 12 L40 18 Z"),
                               line(2, "M2 19 L50 19")};
constexpr const char* kHook = "M10.3 2.2 L14 5.6 L14 15.4 L10.3 18.8";
constexpr std::array kRadioUp{line(3.5, kHook), line(3, "M14 10.5 L39 10.5"), surface("M38 2 L42 2 L42 19 L38 19 Z")};
constexpr std::array kRadioLost{
    surface("M0 0 L52 0 L52 21 L0 21 Z", Colour::grey), line(3.5, kHook, Colour::red),
    surface("M15 9 L19.8 9 L22 12 L15 12 Z M38 2 L42 2 L42 19 L38 19 L38 12 L34 12 L31.8 9 L38 9 Z", Colour::red)};
constexpr std::array kHourGlass{line(2, "M2 2 L18 2 M2 18 L18 18"), line(2, "M3 2 L3 5 L8 9.8 L3 14.8 L3 18"),
                                line(2, "M17 2 L17 5 L12 9.8 L17 14.8 L17 18"),
                                surface("M3.5 5.6 L16.5 5.6 L12 9.8 L10.6 13 L9.4 13 L8 9.8 Z"),
                                surface("M4.5 17.5 L7 15.7 L10 14.7 L13 15.7 L15.5 17.5 Z")};
constexpr std::array kReversingPermitted{
    line(2.2, "M1.1 6 L4.2 6 L10 11.8 L10 21.3 L5 25.7"), surface("M1 11 L2.5 11 L7 15.5 L7 17 L1 17 Z"),
    surface("M11.7 11.5 L17 6.5 L17 16.5 Z"),
    line(2.8, "M16 11.5 L25 11.5 C 28.5 11.5 30.5 14 30.5 17 C 30.5 20 28 22.6 24 22.6")};
constexpr std::array kBmmInhibited{surface("M5 23 L27 23 L27 29 L5 29 Z"), line(2.5, "M10 19 L10 9 M22 19 L22 9"),
                                   line(2.5, "A 16 9 6 270 450"), line(2.5, "M3 3 L29 29 M29 3 L3 29")};

// Track conditions, 32 x 32.
constexpr Mark kWire = surface("M3 2 L30 2 L30 5 L3 5 Z");
constexpr Mark kRoof = surface("M3 25 L30 25 L30 29 L3 29 Z");
constexpr Mark kFoldedHead = surface("M6 17 L23 17 L23 20 L6 20 Z");
constexpr Mark kFoldedArms = line(1.9, "M16.5 19.5 L9.5 22.7 L14 25.5");
constexpr std::array kPantographDown{kWire, kRoof, kFoldedHead, kFoldedArms};
constexpr std::array kLowerPantograph{kWire, kRoof, kFoldedHead, kFoldedArms,
                                      surface("M19 7 L22 7 L22 10 L25.3 10 L20.5 14.7 L15.7 10 L19 10 Z")};
constexpr std::array kRaisePantograph{kWire, kRoof, surface("M8 6 L28 6 L28 9 L8 9 Z"),
                                      line(1.9, "M21.5 8.5 L6.3 18.5 L18.5 25.5"),
                                      surface("M23 22 L26 22 L26 19 L28.5 19 L24.5 14.3 L20.5 19 L23 19 Z")};
constexpr std::array kNeutralSection{
    surface("M5 4 L10 4 L10 18 L5 18 Z M22 4 L27 4 L27 18 L22 18 Z M5 23 L27 23 L27 28 L5 28 Z")};
constexpr std::array kNeutralSectionEnd{surface("M5 4 L10 4 L10 23 L22 23 L22 4 L27 4 L27 28 L5 28 Z")};
constexpr std::array kNoStopping{line(2.1, "M6.5 8 C 1.9 8 1.9 18 6.5 18 C 11.1 18 11.1 8 6.5 8 Z"),
                                 line(2.1, "M7.7 1.5 L28.3 24.5 M28.3 1.5 L7.7 24.5"),
                                 surface("M3 26 L30 26 L30 29 L3 29 Z")};
constexpr std::array kRadioHole{surface("O 8 13 3.6"),         line(1.6, "M8 16 L8 29 M4 29 L12 29"),
                                line(1.5, "A 8 13 8 50 130"),  line(1.5, "A 8 13 13 50 130"),
                                line(1.5, "A 8 13 18 50 130"), line(1.5, "M3 29 L29 3 M3 3 L29 29")};
constexpr Mark kCross = line(2.2, "M2 2 L30 30 M30 2 L2 30");
// A brake above the rail, crossed out.
constexpr std::array kMagneticShoe{line(3, "M16.5 2 L16.5 18"), line(2.1, "M2.7 2.7 L30.3 30.3 M30.3 2.7 L2.7 30.3"),
                                   surface("M3 18 L30 18 L30 23 L27 23 L27 21 L18 21 L18 23 L15 23 L15 21 L6 21 "
                                           "L6 23 L3 23 Z M3 25 L30 25 L30 28 L3 28 Z")};
constexpr std::array kEddyCurrent{line(3, "M16.5 1.5 L16.5 17"), line(2.1, "M2.7 1.7 L30.3 29.3 M30.3 1.7 L2.7 29.3"),
                                  surface("M3 17 L30 17 L30 20 L3 20 Z M3 25 L30 25 L30 28 L3 28 Z"),
                                  line(1.6, "M11.3 24 L13.8 21.5 L16.5 24 L19.2 21.5 L21.7 24")};
constexpr std::array kRegenerative{line(2.2, "O 16 16 11.8"), line(2, "O 16 16 6.8"),
                                   surface("M1 10 L5 10 L5 22 L1 22 Z M27 10 L31 10 L31 22 L27 22 Z"), kCross,
                                   line(1.6, "M13 19 L13 13 L19 19 L19 13")};
constexpr Mark kHousingFoot = surface("M8 27.5 L16 27.5 L16 28.5 L14 31 L10 31 L8 28.5 Z");
constexpr std::array kAirIntakeClosed{line(3, "M1.5 2.5 L20.3 2.5 L27.5 9.8 L27.5 21.5 L22.5 26.5 L1.5 26.5"),
                                      kHousingFoot, line(2.3, "M5 9 L16 9 L19 12 L19 15.7 L15.7 19 L7 19"),
                                      surface("M3.3 19 L8.2 14.5 L8.2 23.5 Z")};
constexpr std::array kAirIntakeOpen{
    line(3, "M1.5 2.5 L20.3 2.5 L23 6.5"), line(3, "M27.5 13 L27.5 21.5 L22.5 26.5 L1.5 26.5"), kHousingFoot,
    line(2.7, "M30.6 9.7 L25.5 9.7 L19 16.5 L10 16.5"), surface("M6.3 16.5 L11.7 11.5 L11.7 21.5 Z")};
constexpr std::array kNoTractionSystem{line(1.5, "M16 3.8 L28.2 16 L16 28.2 L3.8 16 Z"),
                                       line(1.5, "M16 9.6 L22.4 16 L16 22.4 L9.6 16 Z")};
constexpr std::array k25kV{letters("25", 16, 15, 10), letters("kV", 16, 27, 9)};
constexpr std::array k15kV{letters("15", 16, 15, 10), letters("kV", 16, 27, 9)};
constexpr std::array k3000V{letters("3000", 16, 15, 9), letters("V", 16, 27, 9)};
constexpr std::array k1500V{letters("1500", 16, 15, 9), letters("V", 16, 27, 9)};
constexpr std::array k750V{letters("750", 16, 15, 10), letters("V", 16, 27, 9)};
constexpr std::array kHorn{
    surface("M7 11 L14 11 L14 15 L15.5 15 L25 10 L27 10 L27 23 L25 23 L15.5 18 L14 18 L14 22 L7 22 Z")};
constexpr Mark kArch = surface("A 16 14 11 270 450 L21.5 14 C 21.5 7.5 10.5 7.5 10.5 14 Z");
constexpr std::array kTunnel{kArch, surface("M4 22 L11 22 L11 29.5 L4 29.5 Z M21 22 L28 22 L28 29.5 L21 29.5 Z"),
                             surface("M1 18 L4.5 15 L4.5 17 L13 17 L13 19 L4.5 19 L4.5 21 Z "
                                     "M31 18 L27.5 15 L27.5 17 L19 17 L19 19 L27.5 19 L27.5 21 Z")};

// Planning, 20 x 20, where they are not those of the track conditions, smaller. The bars of the speed changes are in
// rows 3 and 4, or 17 and 18, from column 2 to 18.
constexpr std::array kSpeedUp{surface("M2 17 L19 17 L19 19 L2 19 Z M14.5 7.5 L18 16 L11 16 Z")};
constexpr std::array kSpeedDown{surface("M2 3 L19 3 L19 5 L2 5 Z M14.5 14.5 L18 6 L11 6 Z")};

// Navigation.
constexpr std::array kPlus12{surface("M5 1 L7 1 L7 5 L11 5 L11 7 L7 7 L7 11 L5 11 L5 7 L1 7 L1 5 L5 5 Z")};
constexpr std::array kMinus12{surface("M1 7 L11 7 L11 9 L1 9 Z")};
constexpr std::array kPlus{
    surface("M14 6 L18 6 L18 14 L26 14 L26 18 L18 18 L18 26 L14 26 L14 18 L6 18 L6 14 L14 14 Z")};
constexpr std::array kMinus{surface("M6 14 L26 14 L26 18 L6 18 Z")};
constexpr std::array kClose{line(3, "M5 5 L27 27 M27 5 L5 27")};
constexpr std::array kUp{surface("M16 6 L26 25 L6 25 Z")};
constexpr std::array kDown{surface("M6 7 L26 7 L16 26 Z")};
constexpr std::array kNext{surface("M7 6 L26 16 L7 26 Z")};
constexpr std::array kPrevious{surface("M25 6 L6 16 L25 26 Z")};
constexpr std::array kEnter{surface("M2 19 L13 13 L13 17.5 L27 17.5 L27 8 L30 8 L30 20.5 L13 20.5 L13 25 Z")};
constexpr std::array kDelete{letters("Del", 16, 21.5, 12)};
constexpr std::array kMore{
    surface("M8 15 L11 15 L11 18 L8 18 Z M15 15 L18 15 L18 18 L15 18 Z M22 15 L25 15 L25 18 L22 18 Z")};

// Settings.
constexpr std::array kBrightness{line(2, "O 16 16 8"),
                                 line(2,
                                      "M16 1 L16 5 M16 27 L16 31 M1 16 L5 16 M27 16 L31 16 M5.4 5.4 L8.2 8.2 "
                                      "M23.8 23.8 L26.6 26.6 M26.6 5.4 L23.8 8.2 M8.2 23.8 L5.4 26.6")};
constexpr std::array kVolume{line(2, "M8 11 L16 11 L16 21 L8 21 Z"), line(2, "M16 11 L27 3.5 L27 28.5 L16 21"),
                             line(1.8, "M4 4.5 L10 4.5 M7 1.5 L7 7.5 M4 27.5 L10 27.5")};
constexpr std::array kLanguage{
    surface("M3 4 L6 4 L6 26 L3 26 Z"),
    line(2,
         "M8 8 C 10.5 4.5 14 4 17 6.2 C 20 8.4 23 8.4 25.5 6 L28 6 L28 17 L25.5 17 C 23 19.4 20 19.4 17 17 "
         "C 14 14.8 10.5 15 8 18.5 Z")};
constexpr std::array kSettings{line(3.7, "M10.5 21.5 L21.5 10.5"),
                               line(2.8, "M22.5 2.5 L20.3 5 L20.5 8.5 L23.5 11.5 L27 11.7 L29.8 9.2"),
                               line(2.8, "M9.5 29.5 L11.7 27 L11.5 23.5 L8.5 20.5 L5 20.3 L2.2 22.8")};

// Driver's requests.
constexpr std::array kToggle{line(1.8, "A 16 19 13 322 398"),
                             surface("M7 5.8 L10.7 9.2 L7 9.2 Z M25 5.8 L25 9.2 L21.3 9.2 Z"),
                             line(3.5, "M3.3 11.3 L14.5 22.3"), line(1.2, "M16.5 19.3 L27 10.2 L30 12.3 L20.5 21.3"),
                             surface("M12 20.5 L20 20.5 L28 25 L28 26.5 L4 26.5 L4 25 Z")};
constexpr std::array kTrackAheadFree{surface("M0 0 L75 0 L75 46 L0 46 Z", Colour::dark_grey),
                                     line(2, "M1 23 L74 41 M1 32 L40 45"), line(2, "M50 5.5 L71 16 L50 26.5"),
                                     surface("M51.5 9 C 56 12 56 20 51.5 23 C 47 20 47 12 51.5 9 Z")};
constexpr std::array kGeographicalPosition{
    line(2, "A 16 16 12.5 9 81"),
    line(2, "A 16 16 12.5 99 171"),
    line(2, "A 16 16 12.5 189 261"),
    line(2, "A 16 16 12.5 279 351"),
    line(2,
         "M18 4 L18 10 L22 14 L28 14 M28 18 L22 18 L18 22 L18 28 M14 28 L14 22 L10 18 L4 18 "
         "M4 14 L10 14 L14 10 L14 4"),
    surface("O 16 16 2.2")};
constexpr std::array kAcknowledge{letters("Ack", 16, 21.5, 11)};
constexpr std::array kTunnelToggle{
    line(3.8, "A 16 15 10 272 448"),
    surface("M4 22 L8 22 L8 29 L3 29 L3 24 L4 24 Z M28 22 L24 22 L24 29 L29 29 L29 24 L28 24 Z"),
    letters("?", 16, 28, 15.5)};
constexpr std::array kLevelCrossing{
    surface("M14 6 L17 6 L17 28 L21 28 L21 29.5 L10 29.5 L10 28 L14 28 Z"),
    line(2.8, "M5 6.2 L26 18.8 M26 6.2 L5 18.8"),
    surface("M4 5 L7 5 L7 8 L4 8 Z M24 5 L27 5 L27 8 L24 8 Z M4 17 L7 17 L7 20 L4 20 Z M24 17 L27 17 L27 20 L24 20 Z")};
constexpr std::array kLssma{line(3, "M3.5 3.5 L46.5 3.5 L46.5 46.5 L3.5 46.5 Z"),
                            surface("M8.5 8.5 L14 8.5 L14 14 L8.5 14 Z M36 8.5 L41.5 8.5 L41.5 14 L36 14 Z "
                                    "M8.5 36 L14 36 L14 41.5 L8.5 41.5 Z M36 36 L41.5 36 L41.5 41.5 L36 41.5 Z")};

// Supervised manoeuvre: which way.
constexpr std::array kSmForward{surface("M16 2 L27 13 L20.5 13 L20.5 20 L11.5 20 L11.5 13 L5 13 Z"),
                                surface("M6 23 L26 23 L26 29 L6 29 Z")};
constexpr std::array kSmBackward{surface("M16 30 L27 19 L20.5 19 L20.5 12 L11.5 12 L11.5 19 L5 19 Z"),
                                 surface("M6 3 L26 3 L26 9 L6 9 Z")};

// Automatic train operation, 45 x 45.
constexpr std::array kAtoSelected{line(2, "O 22.5 22.5 20"), letters("ATO", 22.5, 27.5, 10)};
constexpr std::array kAtoReady{line(2, "O 22.5 22.5 20"), letters("ATO", 22.5, 21, 9),
                               surface("M17 26 L29 32 L17 38 Z")};
constexpr std::array kAtoEngaged{surface("O 22.5 22.5 21"), letters("ATO", 22.5, 27.5, 10, Colour::black)};
constexpr std::array kAtoDisengaging{line(2, "O 22.5 22.5 20", Colour::grey), letters("ATO", 22.5, 21, 9, Colour::grey),
                                     surface("M17 26 L28 26 L28 37 L17 37 Z", Colour::red)};
constexpr std::array kAtoFailure{line(2, "O 22.5 22.5 20", Colour::grey), letters("ATO", 22.5, 27.5, 10, Colour::grey),
                                 line(3, "M9 9 L36 36 M36 9 L9 36", Colour::red)};
constexpr Mark kPlatform = surface("M3 35 L42 35 L42 40 L3 40 Z");
constexpr Mark kStopPlate = line(2, "M22.5 6 L22.5 32");
constexpr std::array kOvershoot{kPlatform, kStopPlate,
                                surface("M27 19 L36 12 L36 16.5 L42 16.5 L42 21.5 L36 21.5 L36 26 Z")};
constexpr std::array kUndershoot{kPlatform, kStopPlate,
                                 surface("M18 19 L9 12 L9 16.5 L3 16.5 L3 21.5 L9 21.5 L9 26 Z")};
constexpr std::array kAccurateStop{
    kPlatform, kStopPlate,
    surface("M21 19 L13 13 L13 17 L4 17 L4 21 L13 21 L13 25 Z M24 19 L32 13 L32 17 L41 17 L41 21 "
            "L32 21 L32 25 Z")};
constexpr std::array kTrainHold{line(2.5, "O 22.5 22.5 18"),
                                surface("M15 13 L20 13 L20 32 L15 32 Z M25 13 L30 13 L30 32 L25 32 Z")};
constexpr Mark kCoach = line(2, "M12 4 L33 4 L33 41 L12 41 Z");
constexpr Mark kLeftDoorOpens = surface("M2 22.5 L8 16.5 L8 20.5 L15 20.5 L15 24.5 L8 24.5 L8 28.5 Z");
constexpr Mark kRightDoorOpens = surface("M43 22.5 L37 16.5 L37 20.5 L30 20.5 L30 24.5 L37 24.5 L37 28.5 Z");
constexpr std::array kOpenBoth{kCoach, kLeftDoorOpens, kRightDoorOpens};
constexpr std::array kOpenLeft{kCoach, kLeftDoorOpens};
constexpr std::array kOpenRight{kCoach, kRightDoorOpens};
constexpr Mark kDoorFrame = line(2, "M4 6 L41 6 L41 39 L4 39 Z");
constexpr std::array kDoorsOpen{kDoorFrame, surface("M6 8 L12 8 L12 37 L6 37 Z M33 8 L39 8 L39 37 L33 37 Z")};
constexpr std::array kCloseDoors{kDoorFrame, surface("M6 8 L10 8 L10 37 L6 37 Z M35 8 L39 8 L39 37 L35 37 Z"),
                                 surface("M21 22.5 L15.5 17 L15.5 21 L11.5 21 L11.5 24 L15.5 24 L15.5 28 Z "
                                         "M24 22.5 L29.5 17 L29.5 21 L33.5 21 L33.5 24 L29.5 24 L29.5 28 Z")};
constexpr std::array kDoorsClosed{kDoorFrame, surface("M6 8 L21.5 8 L21.5 37 L6 37 Z M23.5 8 L39 8 L39 37 L23.5 37 Z")};
constexpr Mark kOverStation = line(2.5, "A 22.5 27 15 285 430");
constexpr Mark kOverStationHead = surface("M41 26.5 L31 24 L39 17 Z");
constexpr std::array kSkipInactive{surface("M14 29 L31 29 L31 40 L14 40 Z"), line(2, "M5 22 L40 22 M22.5 16 L22.5 28")};
constexpr std::array kSkipByTrackside{surface("M14 29 L31 29 L31 40 L14 40 Z"), kOverStation, kOverStationHead};
constexpr std::array kSkipByDriver{surface("M14 29 L31 29 L31 40 L14 40 Z"), kOverStation, kOverStationHead,
                                   line(2, "M2.5 2.5 L42.5 2.5 L42.5 42.5 L2.5 42.5 Z")};
constexpr std::array kCoasting{surface("O 9 22 3 O 23 22 3"), surface("M4 12 L23 12 L28 19 L4 19 Z"),
                               line(1.8, "M4 28 C 8 25 12 31 16 28 C 20 25 24 31 28 28")};
constexpr std::array kStoppingPoint{line(1.8, "M2.5 2.5 L17.5 2.5 L17.5 17.5 L2.5 17.5 Z"), letters("S", 10, 14.5, 9)};

constexpr Point kWide{52, 21}, kSquare{32, 32}, kSmall{20, 20}, kTiny{12, 12}, kAto{45, 45};
constexpr Colour grey = Colour::grey, yellow = Colour::yellow, dark_grey = Colour::dark_grey, white = Colour::white;
using P = Picture;

// clang-format off
constexpr std::array<Drawn, terms::index(Picture::count)> kRows{{
    {P::LE01, grey, kWide, kLevel0}, {P::LE02, grey, kWide, kLevelNtc}, {P::LE03, grey, kWide, kLevel1},
    {P::LE04, grey, kWide, kLevel2}, {P::LE05, grey, kWide, kLevel3}, {P::LE06, grey, kWide, kTo0},
    {P::LE07, yellow, kWide, kTo0}, {P::LE08, grey, kWide, kToNtc}, {P::LE09, yellow, kWide, kToNtc},
    {P::LE10, grey, kWide, kTo1}, {P::LE11, yellow, kWide, kTo1}, {P::LE12, grey, kWide, kTo2},
    {P::LE13, yellow, kWide, kTo2}, {P::LE14, grey, kWide, kTo3}, {P::LE15, yellow, kWide, kTo3},
    {P::MO01, grey, kSquare, kShunting}, {P::MO02, yellow, kSquare, kShunting}, {P::MO03, grey, kSquare, kOverride},
    {P::MO04, grey, kSquare, kTrip}, {P::MO05, yellow, kSquare, kSignal}, {P::MO06, grey, kSquare, kSignal},
    {P::MO07, grey, kSquare, kOnSight}, {P::MO08, yellow, kSquare, kOnSight},
    {P::MO09, grey, kSquare, kStaffResponsible}, {P::MO10, yellow, kSquare, kStaffResponsible},
    {P::MO11, grey, kSquare, kFullSupervision}, {P::MO12, grey, kSquare, kNonLeading},
    {P::MO13, grey, kSquare, kStandBy}, {P::MO14, grey, kSquare, kReversing}, {P::MO15, yellow, kSquare, kReversing},
    {P::MO16, grey, kSquare, kUnfitted}, {P::MO17, yellow, kSquare, kUnfitted},
    {P::MO18, grey, kSquare, kSystemFailure}, {P::MO19, grey, kSquare, kNationalSystem},
    {P::MO20, yellow, kSquare, kNationalSystem}, {P::MO21, grey, kSquare, kLimitedSupervision},
    {P::MO22, yellow, kSquare, kLimitedSupervision}, {P::MO23, grey, kSquare, kAutomaticDriving},
    {P::MO24, grey, kSquare, kSupervisedManoeuvre},
    {P::ST01, grey, kWide, kBrake}, {P::ST02, grey, kWide, kSlippery}, {P::ST03, grey, kWide, kRadioUp},
    {P::ST04, grey, kWide, kRadioLost}, {P::ST05, grey, kSmall, kHourGlass},
    {P::ST06, grey, kSquare, kReversingPermitted}, {P::ST07, grey, kSquare, kBmmInhibited},
    {P::TC01, grey, kSquare, kPantographDown}, {P::TC02, grey, kSquare, kLowerPantograph},
    {P::TC03, yellow, kSquare, kLowerPantograph}, {P::TC04, grey, kSquare, kRaisePantograph},
    {P::TC05, yellow, kSquare, kRaisePantograph}, {P::TC06, grey, kSquare, kNeutralSection},
    {P::TC07, yellow, kSquare, kNeutralSection}, {P::TC08, grey, kSquare, kNeutralSectionEnd},
    {P::TC09, yellow, kSquare, kNeutralSectionEnd}, {P::TC10, grey, kSquare, kNoStopping},
    {P::TC11, yellow, kSquare, kNoStopping}, {P::TC12, grey, kSquare, kRadioHole},
    {P::TC13, grey, kSquare, kMagneticShoe}, {P::TC14, yellow, kSquare, kMagneticShoe},
    {P::TC15, grey, kSquare, kEddyCurrent}, {P::TC16, yellow, kSquare, kEddyCurrent},
    {P::TC17, grey, kSquare, kRegenerative}, {P::TC18, yellow, kSquare, kRegenerative},
    {P::TC19, grey, kSquare, kAirIntakeClosed}, {P::TC20, grey, kSquare, kAirIntakeOpen},
    {P::TC21, yellow, kSquare, kAirIntakeClosed}, {P::TC22, yellow, kSquare, kAirIntakeOpen},
    {P::TC23, grey, kSquare, kNoTractionSystem}, {P::TC24, yellow, kSquare, kNoTractionSystem},
    {P::TC25, grey, kSquare, k25kV}, {P::TC26, yellow, kSquare, k25kV}, {P::TC27, grey, kSquare, k15kV},
    {P::TC28, yellow, kSquare, k15kV}, {P::TC29, grey, kSquare, k3000V}, {P::TC30, yellow, kSquare, k3000V},
    {P::TC31, grey, kSquare, k1500V}, {P::TC32, yellow, kSquare, k1500V}, {P::TC33, grey, kSquare, k750V},
    {P::TC34, yellow, kSquare, k750V}, {P::TC35, yellow, kSquare, kHorn}, {P::TC36, grey, kSquare, kTunnel},
    {P::TC37, yellow, kSquare, kTunnel},
    {P::PL01, grey, kSquare, kLowerPantograph}, {P::PL02, yellow, kSquare, kLowerPantograph},
    {P::PL03, grey, kSquare, kRaisePantograph}, {P::PL04, yellow, kSquare, kRaisePantograph},
    {P::PL05, grey, kSquare, kNeutralSection}, {P::PL06, yellow, kSquare, kNeutralSection},
    {P::PL07, grey, kSquare, kNeutralSectionEnd}, {P::PL08, yellow, kSquare, kNeutralSectionEnd},
    {P::PL09, yellow, kSquare, kNoStopping}, {P::PL10, grey, kSquare, kRadioHole},
    {P::PL11, grey, kSquare, kMagneticShoe}, {P::PL12, yellow, kSquare, kMagneticShoe},
    {P::PL13, grey, kSquare, kEddyCurrent}, {P::PL14, yellow, kSquare, kEddyCurrent},
    {P::PL15, grey, kSquare, kRegenerative}, {P::PL16, yellow, kSquare, kRegenerative},
    {P::PL17, grey, kSquare, kAirIntakeClosed}, {P::PL18, grey, kSquare, kAirIntakeOpen},
    {P::PL19, yellow, kSquare, kAirIntakeClosed}, {P::PL20, yellow, kSquare, kAirIntakeOpen},
    {P::PL21, grey, kSmall, kSpeedUp}, {P::PL22, grey, kSmall, kSpeedDown}, {P::PL23, yellow, kSmall, kSpeedDown},
    {P::PL24, yellow, kSquare, kHorn}, {P::PL25, grey, kSquare, kNoTractionSystem},
    {P::PL26, yellow, kSquare, kNoTractionSystem}, {P::PL27, grey, kSquare, k25kV}, {P::PL28, yellow, kSquare, k25kV},
    {P::PL29, grey, kSquare, k15kV}, {P::PL30, yellow, kSquare, k15kV}, {P::PL31, grey, kSquare, k3000V},
    {P::PL32, yellow, kSquare, k3000V}, {P::PL33, grey, kSquare, k1500V}, {P::PL34, yellow, kSquare, k1500V},
    {P::PL35, grey, kSquare, k750V}, {P::PL36, yellow, kSquare, k750V}, {P::PL37, white, kSmall, kSpeedDown},
    {P::NA03, grey, kTiny, kPlus12}, {P::NA04, grey, kTiny, kMinus12}, {P::NA05, dark_grey, kTiny, kPlus12},
    {P::NA06, dark_grey, kTiny, kMinus12}, {P::NA07, grey, kSquare, kPlus}, {P::NA08, grey, kSquare, kMinus},
    {P::NA09, dark_grey, kSquare, kPlus}, {P::NA10, dark_grey, kSquare, kMinus}, {P::NA11, grey, kSquare, kClose},
    {P::NA12, dark_grey, kSquare, kClose}, {P::NA13, grey, kSquare, kUp}, {P::NA14, grey, kSquare, kDown},
    {P::NA15, dark_grey, kSquare, kUp}, {P::NA16, dark_grey, kSquare, kDown}, {P::NA17, grey, kSquare, kNext},
    {P::NA18, grey, kSquare, kPrevious}, {P::NA18_2, dark_grey, kSquare, kNext}, {P::NA19, dark_grey, kSquare, kPrevious},
    {P::NA20, grey, kSquare, kEnter}, {P::NA21, grey, kSquare, kDelete}, {P::NA22, dark_grey, kSquare, kEnter},
    {P::NA23, grey, kSquare, kMore},
    {P::SE01, grey, kSquare, kBrightness}, {P::SE02, grey, kSquare, kVolume}, {P::SE03, grey, kSquare, kLanguage},
    {P::SE04, grey, kSquare, kSettings},
    {P::DR01, grey, kSquare, kToggle}, {P::DR02, grey, {75, 46}, kTrackAheadFree},
    {P::DR03, grey, kSquare, kGeographicalPosition}, {P::DR04, yellow, kSquare, kAcknowledge},
    {P::DR05, grey, kSquare, kTunnelToggle},
    {P::LX01, grey, kSquare, kLevelCrossing}, {P::LS01, grey, {50, 50}, kLssma},
    {P::SM01, grey, kSquare, kSmForward}, {P::SM02, grey, kSquare, kSmBackward},
    {P::ATO01, grey, kAto, kAtoSelected}, {P::ATO02, yellow, kAto, kAtoReady}, {P::ATO03, white, kAto, kAtoEngaged},
    {P::ATO04, grey, kAto, kAtoDisengaging}, {P::ATO05, grey, kAto, kAtoFailure},
    {P::ATO06, yellow, kAto, kOvershoot}, {P::ATO07, yellow, kAto, kUndershoot}, {P::ATO08, grey, kAto, kAccurateStop},
    {P::ATO09, grey, kAto, kTrainHold}, {P::ATO10, yellow, kAto, kOpenBoth}, {P::ATO11, yellow, kAto, kOpenLeft},
    {P::ATO12, yellow, kAto, kOpenRight}, {P::ATO13, grey, kAto, kDoorsOpen}, {P::ATO14, yellow, kAto, kCloseDoors},
    {P::ATO15, grey, kAto, kCloseDoors}, {P::ATO16, grey, kAto, kDoorsClosed},
    {P::ATO17, grey, kAto, kSkipInactive}, {P::ATO18, grey, kAto, kSkipByTrackside},
    {P::ATO19, white, kAto, kSkipByDriver}, {P::ATO20, grey, kSquare, kCoasting},
    {P::ATO21, grey, kSmall, kStoppingPoint},
}};
// clang-format on
static_assert([] {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (terms::index(kRows[i].picture) != i || kRows[i].marks.empty()) return false;
  return true;
}());

/// The next decimal number of a path.
double take_decimal(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  double number = 0.0;
  double unit = 1.0;
  bool fraction = false;
  for (; !text.empty(); text.remove_prefix(1)) {
    const char c = text.front();
    if (c == '.') {
      fraction = true;
    } else if (c >= '0' && c <= '9') {
      if (fraction) unit /= 10.0;
      number = fraction ? number + unit * (c - '0') : 10.0 * number + (c - '0');
    } else {
      break;
    }
  }
  return negative ? -number : number;
}

/// From the box of a drawing to the screen. Both scales of a symbol are the same, but for rounding.
struct Placing {
  Point at;
  double scale = 1.0;
  Point of(double x, double y) const { return {at.x + scale * x, at.y + scale * y}; }
};

Path path_of(std::string_view text, const Placing& placing) {
  Path path;
  const auto point = [&] {
    const double x = take_decimal(text);
    const double y = take_decimal(text);
    return placing.of(x, y);
  };
  bool begun = false;
  while (!text.empty()) {
    const char letter = text.front();
    text.remove_prefix(1);
    if (letter == 'M') path.move_to(point());
    if (letter == 'L') path.line_to(point());
    if (letter == 'Z') path.close();
    if (letter == 'C') {
      const Point a = point();
      const Point b = point();
      path.curve_to(a, b, point());
    }
    if (letter == 'O') {
      const Point centre = point();
      path.circle(centre, placing.scale * take_decimal(text));
    }
    if (letter == 'A') {
      const Point centre = point();
      const double radius = placing.scale * take_decimal(text);
      const double from = take_decimal(text);
      path.arc(centre, radius, from, take_decimal(text), begun ? Path::Kind::line : Path::Kind::move);
    }
    if (letter != ' ') begun = true;
  }
  return path;
}

}  // namespace

const std::span<const Drawn> kSymbols{kRows};

std::vector<Shape> shapes_of(Picture picture, Point at) {
  const Drawn& symbol = kRows[terms::index(picture)];
  const PictureRow& size = kPictureRows[terms::index(picture)];
  const Placing placing{at, std::min(size.width / symbol.box.x, size.height / symbol.box.y)};
  std::vector<Shape> shapes;
  for (const Mark& mark : symbol.marks) {
    Shape shape{{}, mark.colour == Colour::none ? symbol.colour : mark.colour, 0.0};
    if (mark.kind == Mark::Kind::letters) {
      const double height = placing.scale * mark.width;
      Point left = placing.of(mark.base.x, mark.base.y);
      left.x -= width_of(mark.path, height, false) / 2.0;
      add_text(shape.path, mark.path, left, height, false);
    } else {
      shape.path = path_of(mark.path, placing);
      if (mark.kind == Mark::Kind::line) shape.stroke = placing.scale * mark.width;
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace evc::paint
