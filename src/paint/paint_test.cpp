#include <gtest/gtest.h>

#include <cairo/cairo.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>

#include "base/test_paths.h"
#include "paint/drawing.h"
#include "paint/font.h"
#include "paint/path_text.h"
#include "paint/png.h"
#include "paint/svg.h"
#include "paint/symbols.h"

namespace evc::paint {
namespace {

using dmi::Area;
using dmi::Colour;
using dmi::Item;
using dmi::Kind;
using dmi::Screen;

std::unique_ptr<Screen> screen_with(std::initializer_list<Item> items) {
  auto screen = std::make_unique<Screen>();
  screen->window = "default";
  for (const Item& item : items) EXPECT_TRUE(screen->items.push_back(item));
  return screen;
}

Item text_item(std::string_view text, std::uint8_t height = 12) {
  Item item;
  item.kind = Kind::text;
  item.area = Area::screen;
  item.at = {100, 100, 200, 50};
  item.colour = Colour::white;
  item.height = height;
  item.text = dmi::Words(text);
  return item;
}

/// An item of each kind with everything it may need.
Item item_of(Kind kind) {
  Item item;
  item.kind = kind;
  item.area = Area::screen;
  item.colour = Colour::white;
  item.background = Colour::dark_grey;
  item.at = {100, 100, 60, 50};
  item.data_at = {130, 100, 30, 50};
  item.from_deg = -144.0;
  item.to_deg = -20.0;
  item.r_in = 100;
  item.r_out = 125;
  item.w = 6;
  item.height = 12;
  item.label_right = 120;
  item.data_left = 130;
  item.baseline = 120;
  item.border = dmi::Border::button;
  item.sides = dmi::kTop | dmi::kLeft | dmi::kBottom | dmi::kRight;
  item.name = "label";
  item.text = "123";
  if (kind == Kind::symbol) item.picture = Picture::MO11;
  return item;
}

/// Pixels of a PNG, read back by Cairo.
class Pixels {
 public:
  explicit Pixels(const std::string& png)
      : left_(png), surface_(cairo_image_surface_create_from_png_stream(&read, this)) {
    cairo_surface_flush(surface_);
  }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
  ~Pixels() { cairo_surface_destroy(surface_); }
  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  std::array<int, 3> at(int x, int y) const {
    const unsigned char* p =
        cairo_image_surface_get_data(surface_) + y * cairo_image_surface_get_stride(surface_) + 4 * x;
    return {p[2], p[1], p[0]};
  }

 private:
  static cairo_status_t read(void* self, unsigned char* out, unsigned int length) {
    std::string& left = static_cast<Pixels*>(self)->left_;
    if (left.size() < length) return CAIRO_STATUS_READ_ERROR;
    left.copy(reinterpret_cast<char*>(out), length);
    left.erase(0, length);
    return CAIRO_STATUS_SUCCESS;
  }
  std::string left_;
  cairo_surface_t* surface_;
};

std::array<int, 3> rgb(Colour colour) {
  const auto& row = dmi::kColourRows[terms::index(colour)].rgb;
  return {row[0], row[1], row[2]};
}

/// A reader of XML for elements with attributes and text alone: why it is not well-formed, or nothing.
std::string fault_of_xml(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = 0;
  const auto bad_characters = [](std::string_view part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto c = static_cast<unsigned char>(part[i]);
      if (c < 0x20 && c != '\n') return true;
      if (c == '<' || c == '>' || c == '"') return true;
      if (c == '&' && part.substr(i, 5) != "&amp;" && part.substr(i, 4) != "&lt;" && part.substr(i, 4) != "&gt;" &&
          part.substr(i, 6) != "&quot;")
        return true;
      // UTF-8: two bytes, or the dash of three.
      const auto follows = [&](std::size_t k) {
        return k < part.size() && (static_cast<unsigned char>(part[k]) & 0xC0U) == 0x80U;
      };
      if (c < 0x80) continue;
      const bool two = c >= 0xC2 && c < 0xE0 && follows(i + 1);
      if (!two && part.substr(i, 3) != "\xE2\x80\x93") return true;
      i += two ? 1 : 2;
    }
    return false;
  };
  while (at < text.size()) {
    const std::size_t begin = text.find('<', at);
    if (bad_characters(std::string_view(text).substr(at, begin == std::string::npos ? begin : begin - at)))
      return "characters at " + std::to_string(at);
    if (begin == std::string::npos) break;
    const std::size_t end = text.find('>', begin);
    if (end == std::string::npos) return "no end of an element";
    std::string tag = text.substr(begin + 1, end - begin - 1);
    at = end + 1;
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) return "end of " + tag;
      open.pop_back();
      continue;
    }
    const bool closed = tag.ends_with("/");
    if (closed) tag.pop_back();
    const std::string name = tag.substr(0, tag.find(' '));
    for (std::size_t from = name.size(); from < tag.size();) {
      const std::size_t equals = tag.find("=\"", from);
      if (equals == std::string::npos) return "attribute in " + tag;
      const std::size_t quote = tag.find('"', equals + 2);
      if (quote == std::string::npos) return "quotes in " + tag;
      if (bad_characters(std::string_view(tag).substr(equals + 2, quote - equals - 2))) return "characters in " + tag;
      from = quote + 1;
    }
    if (!closed) open.push_back(name);
  }
  return open.empty() ? "" : "no end of " + open.back();
}

TEST(Symbols, AreAllDrawnAndStayInsideTheirSize) {
  ASSERT_EQ(kSymbols.size(), kPictureRows.size());
  for (const PictureRow& row : kPictureRows) {
    const auto shapes = shapes_of(row.value, {10, 20});
    ASSERT_FALSE(shapes.empty()) << row.name;
    for (const Shape& shape : shapes) EXPECT_FALSE(shape.path.steps().empty()) << row.name;
    const Bounds bounds = bounds_of(shapes);
    EXPECT_GE(bounds.least.x, 10.0 - 1e-9) << row.name;
    EXPECT_GE(bounds.least.y, 20.0 - 1e-9) << row.name;
    EXPECT_LE(bounds.most.x, 10.0 + row.width + 1e-9) << row.name;
    EXPECT_LE(bounds.most.y, 20.0 + row.height + 1e-9) << row.name;
  }
}

TEST(Symbols, AreThoseOfTheStandard) {
  const std::filesystem::path file = std::filesystem::path(test::shared_folder()) / "reference/dmi.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << file;
  const auto reference = nlohmann::json::parse(std::ifstream(file));
  const std::set<std::string> own_colour{"grey", "yellow", "white", "dark_grey"};
  int seen = 0;
  for (const auto& [id, facts] : reference["symbols"]["items"].items()) {
    const PictureRow* row = nullptr;
    for (const PictureRow& r : kPictureRows)
      if (r.name == id) row = &r;
    ASSERT_NE(row, nullptr) << id;
    EXPECT_EQ(facts["size"].get<std::string>(), std::to_string(row->width) + "x" + std::to_string(row->height)) << id;
    const std::string colour = facts.value("colour", "grey");
    std::set<std::string> drawn;
    for (const Shape& shape : shapes_of(row->value, {})) drawn.insert(dmi::name(shape.colour));
    EXPECT_TRUE(!own_colour.contains(colour) || drawn.contains(colour)) << id;
    EXPECT_TRUE(colour != "red+grey" || (drawn.contains("red") && drawn.contains("grey"))) << id;
    ++seen;
  }
  EXPECT_GT(seen, 150);
}

TEST(Symbols, ThatMeanDifferentThingsLookDifferent) {
  // Of two symbols of one place the driver must see which it is: colour or shape differ.
  std::set<std::string> seen;
  for (const PictureRow& row : kPictureRows) {
    Item item = item_of(Kind::symbol);
    item.picture = row.value;
    std::string svg = svg_of(*screen_with({item}));
    const std::size_t label = svg.find(std::string("aria-label=\"label ") + row.name + " 123\"");
    ASSERT_NE(label, std::string::npos) << row.name;
    svg.erase(0, svg.find('>', label));
    EXPECT_TRUE(seen.insert(std::to_string(row.width) + svg).second) << row.name << " looks like another symbol";
  }
}

TEST(Font, CapitalLettersAreAsHighAsAsked) {
  for (const bool bold : {false, true})
    for (const double height : {10.0, 12.0, 16.0, 18.0})
      for (const char letter : {'H', 'E', 'T', 'X'}) {
        Shape shape;
        add_text(shape.path, std::string_view(&letter, 1), {5, 40}, height, bold);
        const Bounds bounds = bounds_of({shape});
        EXPECT_NEAR(bounds.most.y, 40.0, 1e-9) << letter;
        EXPECT_NEAR(bounds.most.y - bounds.least.y, height, 1e-9) << letter;
      }
}

TEST(Font, EveryPrintableCharacterHasAnOutline) {
  int outlines = 0;
  for (char32_t character = 0x20; character < 0x180; ++character) {
    if (character >= 0x7F && character < 0xA0) continue;
    const bool space = character == 0x20 || character == 0xA0;
    for (const bool bold : {false, true}) {
      EXPECT_EQ(*glyph_of(character, bold).outline == '\0', space) << static_cast<int>(character);
      EXPECT_GT(glyph_of(character, bold).advance, 0) << static_cast<int>(character);
    }
    ++outlines;
  }
  for (char32_t character = 0x410; character < 0x450; ++character) {
    EXPECT_NE(*glyph_of(character, false).outline, '\0') << static_cast<int>(character);
    ++outlines;
  }
  EXPECT_EQ(outlines + 1, static_cast<int>(kGlyphs));
  EXPECT_EQ(glyph_of(0x2013, false).advance, 1139);
  EXPECT_EQ(&glyph_of(0x2014, false), &glyph_of(U'?', false));
  // Digits are equally wide, so that numbers do not jump.
  for (char32_t digit = U'0'; digit <= U'9'; ++digit)
    EXPECT_EQ(glyph_of(digit, false).advance, glyph_of(U'0', false).advance);
}

TEST(Font, ReadsUtf8AndNothingElse) {
  EXPECT_EQ(readable("a\xC3\xA9\xE2\x80\x93z"), "a\xC3\xA9\xE2\x80\x93z");
  EXPECT_EQ(readable("a\xE9\x01z"), "a??z");           // ISO 8859-1, a control character
  EXPECT_EQ(readable("\xC3"), "?");                    // cut off
  EXPECT_EQ(readable("\xC0\xA0\xE0\x80\xA0"), "???");  // longer than needed
  EXPECT_NEAR(width_of("\xC3\xA9", 12, false), width_of("e", 12, false), 1e-9);
}

TEST(Drawing, TextStandsWhereItIsAligned) {
  for (const auto align : {dmi::Align::left, dmi::Align::centre, dmi::Align::right}) {
    Item item = text_item("H");
    item.align = align;
    item.indent = align == dmi::Align::centre ? 0 : 10;
    const Drawing drawing = draw(*screen_with({item}));
    ASSERT_EQ(drawing.size(), 1U);
    const Bounds bounds = bounds_of(drawing[0].shapes);
    EXPECT_NEAR(bounds.least.y, 119.0, 0.01);  // vertically centred
    EXPECT_NEAR(bounds.most.y, 131.0, 0.01);
    const double width = width_of("H", 12, false);
    const double middle = (bounds.least.x + bounds.most.x) / 2.0;
    const double expected = align == dmi::Align::left     ? 110.0 + width / 2.0
                            : align == dmi::Align::centre ? 200.0
                                                          : 290.0 - width / 2.0;
    EXPECT_NEAR(middle, expected, 0.2);
  }
}

TEST(Drawing, AHookExtendsTowardsZeroFromItsLeadingEdge) {
  Item item = item_of(Kind::hook);
  item.from_deg = 0.0;
  item.w = 6;
  item.r_in = 117;
  item.r_out = 137;
  const Bounds bounds = bounds_of(draw(*screen_with({item}))[0].shapes);
  EXPECT_NEAR(bounds.least.x, 194 - 6, 1e-9);
  EXPECT_NEAR(bounds.most.x, 194, 1e-9);
  EXPECT_NEAR(bounds.least.y, 165 - 137, 1e-9);
  EXPECT_NEAR(bounds.most.y, 165 - 117, 1e-9);
}

TEST(Drawing, LabelsOfTheMenusKeepTheirDistanceFromTheBorder) {
  // Of the width of a button of a menu (015560 Table 22), and of F1 to F5.
  for (const auto& [label, width] : {std::pair{"GSM-R network ID", 153}, std::pair{"Maintain Shunting", 153},
                                     std::pair{"Use short number", 153}, std::pair{"Over-ride", 60}}) {
    Item item = item_of(Kind::button);
    item.name.clear();
    item.at = {100, 100, static_cast<std::int16_t>(width), 50};
    item.background = dmi::Colour::none;
    item.border = dmi::Border::none;
    item.text = label;
    const Bounds bounds = bounds_of(draw(*screen_with({item}))[0].shapes);
    EXPECT_GE(bounds.least.x, 105.0) << label;
    EXPECT_LE(bounds.most.x, 95.0 + width) << label;
    EXPECT_GE(bounds.least.y, 102.0) << label;
    EXPECT_LE(bounds.most.y, 148.0) << label;
  }
}

TEST(Drawing, LongLabelsAreBrokenBetweenWordsInsideTheButton) {
  Item item = item_of(Kind::button);
  item.name.clear();
  item.at = {100, 100, 153, 50};
  item.text = "Mission with one radio system";
  const Drawing drawing = draw(*screen_with({item}));
  ASSERT_EQ(drawing.size(), 1U);
  EXPECT_EQ(drawing[0].label, "Mission with one radio system");
  const Bounds bounds = bounds_of(drawing[0].shapes);
  EXPECT_GE(bounds.least.x, 100.0);
  EXPECT_LE(bounds.most.x, 253.0);
  EXPECT_GE(bounds.least.y, 100.0);
  EXPECT_LE(bounds.most.y, 150.0);
}

// Eight digits in two groups are one line of the data part of a field, sixteen are two (015560 5.1.5.2, 10.3.1).
TEST(Drawing, SixteenDigitsAreTwoLinesInsideTheField) {
  Item item = item_of(Kind::field);
  item.name.clear();
  item.at = {100, 100, 102, 50};
  item.data_at = item.at;
  item.background = dmi::Colour::none;
  item.border = dmi::Border::none;
  item.height = 12;
  item.text = "1638 4001";
  const auto digits = [](const Drawing& drawing) {
    std::vector<Bounds> bounds;
    for (const Shape& shape : drawing.at(0).shapes)
      if (shape.colour != dmi::Colour::medium_grey) bounds.push_back(bounds_of({shape}));
    return bounds;
  };
  const auto one = digits(draw(*screen_with({item})));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_LT(one[0].most.x, 202.0);
  item.text = "0041 7900\n0000 0001";
  const auto two = digits(draw(*screen_with({item})));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_LT(two[0].most.y, two[1].least.y);
  EXPECT_GE(two[0].least.y, 100.0);
  EXPECT_LE(two[1].most.y, 150.0);
}

TEST(Drawing, ALabelIsBrokenAtItsHyphen) {
  Item item = item_of(Kind::button);
  item.at = {100, 100, 60, 50};
  item.text = "Over-ride";
  const Bounds bounds = bounds_of(draw(*screen_with({item}))[0].shapes);
  EXPECT_GE(bounds.least.x, 100.0);
  EXPECT_LE(bounds.most.x, 160.0);
}

TEST(Drawing, ALabelIsBrokenAtItsPlus) {
  Item item = item_of(Kind::key);
  item.name.clear();
  item.at = {100, 100, 102, 50};
  item.text = "FRMCS+GSM-R";
  const Bounds bounds = bounds_of(draw(*screen_with({item}))[0].shapes);
  EXPECT_GE(bounds.least.x, 100.0);
  EXPECT_LE(bounds.most.x, 202.0);
}

// The local time is wider than G13 at the height of other texts (015560 5.1.2, 8.4.4).
TEST(Drawing, ATextInTheMiddleStaysInItsArea) {
  Item item = text_item("12:34:56");
  item.area = Area::G13;
  const dmi::Rect area = dmi::rect_of(Area::G13);
  item.at = {0, 0, area.w, area.h};
  item.align = dmi::Align::centre;
  const Bounds bounds = bounds_of(draw(*screen_with({item}))[0].shapes);
  EXPECT_GE(bounds.least.x, area.x + 3);
  EXPECT_LE(bounds.most.x, area.x + area.w - 3);
  EXPECT_NEAR((bounds.least.x + bounds.most.x) / 2.0, area.x + area.w / 2.0, 1.0);
  EXPECT_NEAR((bounds.least.y + bounds.most.y) / 2.0, area.y + area.h / 2.0, 0.5);
}

TEST(Drawing, EveryKindOfItemIsPainted) {
  for (std::size_t k = 0; k < dmi::kKindNames.size(); ++k) {
    const auto kind = static_cast<Kind>(k);
    const Drawing drawing = draw(*screen_with({item_of(kind)}));
    ASSERT_EQ(drawing.size(), 1U) << dmi::name(kind);
    EXPECT_FALSE(drawing[0].shapes.empty()) << dmi::name(kind);
    const Pixels pixels(png_of(*screen_with({item_of(kind)})));
    int painted = 0;
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 640; ++x)
        if (pixels.at(x, y) != rgb(Colour::dark_blue)) ++painted;
    EXPECT_GT(painted, 5) << dmi::name(kind);
  }
}

TEST(Svg, IsWellFormedForAnyBytes) {
  EXPECT_NE(fault_of_xml("<g><path d=\"M0 0\"/>"), "");
  EXPECT_NE(fault_of_xml("<g a=\"<\"/>"), "");
  EXPECT_NE(fault_of_xml("<g a=\"\x01\"/>"), "");
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::string bytes(random() % 60, '\0');
    for (char& c : bytes) c = static_cast<char>(random() & 0xFFU);
    Item item = item_of(static_cast<Kind>(random() % dmi::kKindNames.size()));
    item.text = dmi::Words(bytes);
    item.name = dmi::Text<32>(bytes);
    auto screen = screen_with({item});
    screen->window = dmi::Text<32>(bytes);
    const std::string svg = svg_of(*screen);
    ASSERT_EQ(fault_of_xml(svg), "") << svg;
    ASSERT_EQ(svg.find("nan"), std::string::npos);
  }
}

TEST(Svg, NumbersAreHundredthsWithoutTrailingZeros) {
  Item item = item_of(Kind::rect);
  item.area = Area::B1;
  item.at = {-10, 3, 7, 9};
  const std::string svg = svg_of(*screen_with({item}));
  EXPECT_NE(svg.find("<path d=\"M159 143L166 143L166 152L159 152Z\" fill=\"#FFFFFF\"/>"), std::string::npos) << svg;
  item = item_of(Kind::dial_line);
  item.from_deg = 90.0;
  item.r_in = 99.5;
  item.r_out = 1e300;
  EXPECT_NE(svg_of(*screen_with({item})).find("M293.5 165L1000000 "), std::string::npos);
}

TEST(Png, HasTheSizeOfTheScreenAndItsColours) {
  Item pointer;
  pointer.kind = Kind::pointer;
  pointer.colour = Colour::yellow;
  pointer.from_deg = 90.0;
  Item ring;
  ring.kind = Kind::arc;
  ring.colour = Colour::orange;
  ring.from_deg = -30.0;
  ring.to_deg = 30.0;
  ring.r_in = 128;
  ring.r_out = 137;
  Item box;
  box.kind = Kind::rect;
  box.area = Area::F1;
  box.at = {0, 0, 60, 50};
  box.colour = Colour::pasp_light;
  Item trip;
  trip.kind = Kind::symbol;
  trip.area = Area::B7;
  trip.at = {2, 2, 32, 32};
  trip.picture = Picture::MO04;
  const auto screen = screen_with({pointer, ring, box, trip});
  for (const int scale : {1, 2}) {
    const Pixels pixels(png_of(*screen, scale));
    EXPECT_EQ(pixels.width(), 640 * scale);
    EXPECT_EQ(pixels.height(), 480 * scale);
    const auto at = [&](int x, int y) { return pixels.at(x * scale, y * scale); };
    EXPECT_EQ(at(5, 5), rgb(Colour::dark_blue));
    EXPECT_EQ(at(194, 165), rgb(Colour::yellow));           // hub
    EXPECT_EQ(at(194 + 80, 165), rgb(Colour::yellow));      // needle to the right
    EXPECT_EQ(at(194 - 80, 165), rgb(Colour::dark_blue));   // and not to the left
    EXPECT_EQ(at(194 + 107, 165), rgb(Colour::dark_blue));  // behind its tip
    EXPECT_EQ(at(194, 165 - 133), rgb(Colour::orange));     // ring
    EXPECT_EQ(at(194, 165 - 120), rgb(Colour::dark_blue));  // inside it
    EXPECT_EQ(at(600, 40), rgb(Colour::pasp_light));        // the area F1
    EXPECT_EQ(at(293, 274), rgb(Colour::grey));             // ground of the trip symbol
    EXPECT_EQ(at(292 + 12, 273 + 10), rgb(Colour::red));    // its mast
  }
}

TEST(Png, LaterItemsCoverEarlierOnes) {
  Item below = item_of(Kind::rect), above = item_of(Kind::rect);
  below.colour = Colour::red;
  above.colour = Colour::grey;
  EXPECT_EQ(Pixels(png_of(*screen_with({below, above}))).at(120, 120), rgb(Colour::grey));
  EXPECT_EQ(Pixels(png_of(*screen_with({above, below}))).at(120, 120), rgb(Colour::red));
}

std::string form_of(const Shape& shape) {
  std::string form;
  append_form(form, shape);
  return form;
}

TEST(PathText, CellsHaveTwoDecimalsAtMost) {
  const auto text_of = [](double cells) {
    std::string text;
    append_cells(text, cells);
    return text;
  };
  EXPECT_EQ(text_of(0.0), "0");
  EXPECT_EQ(text_of(-0.0), "0");
  EXPECT_EQ(text_of(-0.004), "0");
  EXPECT_EQ(text_of(-0.05), "-0.05");
  EXPECT_EQ(text_of(12.5), "12.5");
  EXPECT_EQ(text_of(639.994), "639.99");
  EXPECT_EQ(text_of(-3.0), "-3");
  EXPECT_EQ(text_of(std::nan("")), "0");
  EXPECT_EQ(text_of(1e300), "1000000");
}

/// The same form for what looks the same: whole cells further, every shape of every kind of item has the same one.
TEST(PathText, TheFormOfAShapeDoesNotDependOnItsPlace) {
  int shapes_seen = 0;
  for (int kind = 0; kind <= static_cast<int>(Kind::cursor); ++kind) {
    const Item here = item_of(static_cast<Kind>(kind));
    Item there = here;
    there.at.x = static_cast<std::int16_t>(there.at.x + 37);
    there.at.y = static_cast<std::int16_t>(there.at.y - 11);
    there.data_at.x = static_cast<std::int16_t>(there.data_at.x + 37);
    there.data_at.y = static_cast<std::int16_t>(there.data_at.y - 11);
    const auto before = shapes_of(here), after = shapes_of(there);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i, ++shapes_seen) {
      const Hundredths a = begin_of(before[i]), b = begin_of(after[i]);
      const bool moved = b.x - a.x == 3700 && b.y - a.y == -1100;
      // The dial and the labelled values have places of their own.
      if (!moved) continue;
      EXPECT_EQ(form_of(before[i]), form_of(after[i])) << kind;
      EXPECT_NE(form_of(before[i]).find("\"M0 0"), std::string::npos);
    }
  }
  EXPECT_GT(shapes_seen, 30);
}

TEST(PathText, AFormHasColourLineAndPath) {
  Shape shape{{}, Colour::grey, 1.5};
  shape.path.move_to({10, 20});
  shape.path.line_to({13, 16.25});
  shape.path.close();
  EXPECT_EQ(form_of(shape), "\"#C3C3C3\",1.5,\"M0 0L3 -3.75Z\"");
  EXPECT_EQ(begin_of(shape), (Hundredths{1000, 2000}));
  std::string path;
  append_path(path, shape.path);
  EXPECT_EQ(path, "M10 20L13 16.25Z");
  EXPECT_EQ(begin_of(Shape{}), Hundredths{});
}

}  // namespace
}  // namespace evc::paint
