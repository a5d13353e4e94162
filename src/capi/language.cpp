#include "openevc/language.h"

#include <string>

#include "capi/codes.h"
#include "capi/guard.h"

using evc::capi::Why;
namespace language = evc::language;

const char* openevc_version(void) noexcept { return EVC_VERSION; }

size_t openevc_alignment(void) noexcept { return evc::capi::kAlignment; }

openevc_result openevc_decode(const openevc_reading* reading, const uint8_t* bytes, size_t bits, char* json,
                              size_t json_size, size_t* length, char* why_text, size_t why_size) noexcept {
  const Why why{why_text, why_size};
  openevc_reading r;
  if (!evc::capi::take(r, reading)) return why.because(OPENEVC_BAD_ARGUMENT, "reading: null, or its size is not set");
  if (bytes == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "bytes: null");
  if (r.form < OPENEVC_BALISE || r.form > OPENEVC_PACKET)
    return why.because(OPENEVC_BAD_ARGUMENT, "reading.form: not an openevc_form");
  return evc::capi::guarded(why, [&] {
    language::Reading how;
    how.form = static_cast<language::Form>(r.form);
    how.direction = r.to_track != 0 ? language::Direction::to_track : language::Direction::to_train;
    if (r.version_x != 0 || r.version_y != 0) how.version = {r.version_x, r.version_y};
    how.tolerant = r.tolerant != 0;
    const language::Text text = language::decode({bytes, (bits + 7) / 8}, bits, how);
    if (text.error) {
      std::string reason = "bit " + std::to_string(text.error->bit);
      if (text.error->packet >= 0) reason += ", packet " + std::to_string(text.error->packet);
      if (!text.error->variable.empty()) reason += ", " + text.error->variable;
      if (text.error->value) reason += " " + std::to_string(*text.error->value);
      return why.because(OPENEVC_REFUSED, reason + ": " + text.error->why);
    }
    return evc::capi::give_text(text.json, json, json_size, length, why);
  });
}
