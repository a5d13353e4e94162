#include "paint/png.h"

#include <cairo/cairo.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>

#include "paint/drawing.h"

namespace evc::paint {
namespace {

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

void take_colour(cairo_t* cairo, dmi::Colour colour) {
  const auto& rgb = dmi::kColourRows[terms::index(colour)].rgb;
  cairo_set_source_rgb(cairo, rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
}

void take_path(cairo_t* cairo, const Path& path) {
  cairo_new_path(cairo);
  for (const Path::Step& step : path.steps()) {
    switch (step.kind) {
      case Path::Kind::move:
        cairo_move_to(cairo, step.end.x, step.end.y);
        break;
      case Path::Kind::line:
        cairo_line_to(cairo, step.end.x, step.end.y);
        break;
      case Path::Kind::curve:
        cairo_curve_to(cairo, step.a.x, step.a.y, step.b.x, step.b.y, step.end.x, step.end.y);
        break;
      case Path::Kind::close:
        cairo_close_path(cairo);
        break;
    }
  }
}

void paint_shape(cairo_t* cairo, const Shape& shape) {
  if (shape.colour == dmi::Colour::none) return;
  take_colour(cairo, shape.colour);
  take_path(cairo, shape.path);
  if (shape.stroke > 0.0) {
    cairo_set_line_width(cairo, shape.stroke);
    cairo_stroke(cairo);
  } else {
    cairo_fill(cairo);
  }
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string png_of(const dmi::Screen& screen, int scale) {
  constexpr dmi::Rect size = dmi::rect_of(dmi::Area::screen);
  scale = std::clamp(scale, 1, 16);
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.w * scale, size.h * scale), &cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), &cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  take_colour(cairo.get(), dmi::Colour::dark_blue);
  cairo_paint(cairo.get());
  for (const Group& group : draw(screen))
    for (const Shape& shape : group.shapes) paint_shape(cairo.get(), shape);
  require(cairo_status(cairo.get()));
  std::string file;
  require(cairo_surface_write_to_png_stream(surface.get(), &append, &file));
  return file;
}

}  // namespace evc::paint
