#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>

#include "curves/drawing.h"

// Drawings as PNG and PDF. The text is in the sans serif font of the system that Cairo finds.
namespace evc::curves {
namespace {

constexpr double kPixels = 2.0;   // of a PNG, for one of the drawing
constexpr double kPoints = 0.75;  // of a PDF: a pixel is 1/96 inch
constexpr double kHalo = 4.0;     // width of the white around names

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

class CairoWriter {
 public:
  explicit CairoWriter(cairo_t* cairo) : cairo_(cairo) {}
  void operator()(const DrawnRect& r) {
    colour(r.fill);
    cairo_rectangle(cairo_, r.x, r.y, r.w, r.h);
    cairo_fill(cairo_);
  }
  void operator()(const DrawnLine& l) {
    colour(l.stroke.colour);
    cairo_set_line_width(cairo_, l.stroke.width);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    double lengths[8];
    int count = 0;
    for (const char* at = l.stroke.dash; *at != '\0' && count < 8;) {
      char* end = nullptr;
      lengths[count++] = std::strtod(at, &end);
      at = end;
    }
    cairo_set_dash(cairo_, lengths, count, 0.0);
    cairo_new_path(cairo_);
    bool pen_up = true;
    for (const auto& [x, y] : l.points) {
      const bool point = std::isfinite(x) && std::isfinite(y);
      if (point && pen_up) cairo_move_to(cairo_, x, y);
      if (point && !pen_up) cairo_line_to(cairo_, x, y);
      pen_up = !point;
    }
    cairo_stroke(cairo_);
  }
  void operator()(const DrawnText& t) {
    cairo_save(cairo_);
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           t.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, t.size);
    cairo_translate(cairo_, t.x, t.y);
    if (t.vertical) cairo_rotate(cairo_, -M_PI / 2.0);
    cairo_text_extents_t size;
    cairo_text_extents(cairo_, t.text.c_str(), &size);
    const double back = *t.anchor == 'm' ? size.x_advance / 2.0 : *t.anchor == 'e' ? size.x_advance : 0.0;
    if (t.halo) {
      cairo_move_to(cairo_, -back, 0.0);
      cairo_text_path(cairo_, t.text.c_str());
      cairo_set_source_rgb(cairo_, 1.0, 1.0, 1.0);
      cairo_set_line_width(cairo_, kHalo);
      cairo_set_dash(cairo_, nullptr, 0, 0.0);
      cairo_stroke(cairo_);
    }
    colour(t.fill);
    cairo_move_to(cairo_, -back, 0.0);
    cairo_show_text(cairo_, t.text.c_str());
    cairo_restore(cairo_);
  }
  void operator()(const Clip& c) {
    cairo_save(cairo_);
    cairo_rectangle(cairo_, c.x, c.y, c.w, c.h);
    cairo_clip(cairo_);
  }
  void operator()(EndOfClip) { cairo_restore(cairo_); }

 private:
  void colour(const char* hex) {
    const auto rgb = static_cast<unsigned>(std::strtoul(hex + 1, nullptr, 16));
    cairo_set_source_rgb(cairo_, (rgb >> 16U) / 255.0, ((rgb >> 8U) & 255U) / 255.0, (rgb & 255U) / 255.0);
  }
  cairo_t* cairo_;
};

void paint(cairo_surface_t* surface, double scale, const Drawing& drawing) {
  require(cairo_surface_status(surface));
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface), &cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  cairo_set_source_rgb(cairo.get(), 1.0, 1.0, 1.0);
  cairo_paint(cairo.get());
  CairoWriter write(cairo.get());
  for (const Element& element : drawing.elements()) std::visit(write, element);
  require(cairo_status(cairo.get()));
}

}  // namespace

std::string png_of(const Drawing& drawing) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(drawing.width() * kPixels)),
                                 static_cast<int>(std::ceil(drawing.height() * kPixels))),
      &cairo_surface_destroy);
  paint(surface.get(), kPixels, drawing);
  std::string file;
  require(cairo_surface_write_to_png_stream(surface.get(), &append, &file));
  return file;
}

std::string pdf_of(const Drawing& drawing) {
  std::string file;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(&append, &file, drawing.width() * kPoints, drawing.height() * kPoints),
      &cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title().c_str());
  // The same drawing is the same file.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  paint(surface.get(), kPoints, drawing);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return file;
}

}  // namespace evc::curves
