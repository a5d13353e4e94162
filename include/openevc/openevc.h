#ifndef OPENEVC_OPENEVC_H
#define OPENEVC_OPENEVC_H
/* The on-board unit, the braking curves and the ETCS language for programs in C and in languages that call C
 * (docs/embedding.md). Link libopenevc.so.0: `pkg-config --cflags --libs openevc`, or openevc::c of the CMake package.
 *
 * - Every object lies in memory that the caller gives: OBJECT_size() bytes, aligned to openevc_alignment(). The library
 *   allocates nothing for it, keeps no pointer to what it was given in a call, and has no state of its own: an object
 *   may be used from any thread, by one at a time; different objects at the same time. To be rid of an object, free
 *   its memory.
 * - Nothing is thrown. A function that can fail returns an `openevc_result` and, where `why` is not null, writes there
 *   what is wrong: text in UTF-8, ended by a zero, cut to `why_size` bytes.
 * - The first member of a struct is its size, set by the caller (openevc_inputs_init, openevc_limits x = {sizeof x}):
 *   a program that was compiled with an older header goes on with a newer library, which neither reads nor writes
 *   beyond that size.
 * - Units are metres, seconds, m/s, m/s2. A number that does not exist is not a number (isnan).
 * - Codes are those of SUBSET-026-7 where it has them (M_MODE, M_LEVEL, NID_C, ...).
 */
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
#define OPENEVC_NOEXCEPT noexcept
extern "C" {
#else
#define OPENEVC_NOEXCEPT
#endif
#if defined(__GNUC__)
#define OPENEVC_API __attribute__((visibility("default")))
#else
#define OPENEVC_API
#endif

#define OPENEVC_VERSION_MAJOR 0
#define OPENEVC_VERSION_MINOR 2
#define OPENEVC_VERSION_PATCH 0

typedef enum openevc_result {
  OPENEVC_OK = 0,
  OPENEVC_BAD_ARGUMENT = 1, /* a null pointer, memory that is too small or not aligned, a struct without its size */
  OPENEVC_TOO_SMALL = 2,    /* a buffer for an answer is too small; how much is needed is said */
  OPENEVC_REFUSED = 3,      /* a text or bits that are not as they have to be, a snapshot that does not fit */
  OPENEVC_NO_MEMORY = 4,    /* the heap gave nothing: only where texts are read or made */
  OPENEVC_DEFECT = 5        /* a defect of the library */
} openevc_result;

/* "0.2.0", of the library that runs. */
OPENEVC_API const char* openevc_version(void) OPENEVC_NOEXCEPT;
/* Of every object's memory, in bytes. */
OPENEVC_API size_t openevc_alignment(void) OPENEVC_NOEXCEPT;

/* ---- The ETCS language ------------------------------------------------------------------------------------------ */

typedef enum openevc_form {
  OPENEVC_BALISE = 0, /* user bits of a balise telegram */
  OPENEVC_LOOP = 1,   /* a Euroloop message */
  OPENEVC_RADIO = 2,  /* a radio message */
  OPENEVC_PACKET = 3  /* one packet */
} openevc_form;

typedef struct openevc_reading {
  uint32_t size;
  int32_t form;      /* openevc_form */
  int32_t to_track;  /* of a message or packet: 1 from the train to the track, 0 the other way */
  uint8_t version_x; /* system version X.Y of the session, for a message or packet; 0.0: 2.1 */
  uint8_t version_y;
  uint8_t tolerant; /* 1: spare codes are taken, too */
  uint8_t reserved;
} openevc_reading;

/* The JSON text (docs/decode.md) of the first `bits` bits of `bytes`, left aligned. Into `json` goes the text with a
 * zero at its end; into `length`, where not null, its length without it, also with OPENEVC_TOO_SMALL. */
OPENEVC_API openevc_result openevc_decode(const openevc_reading* reading, const uint8_t* bytes, size_t bits, char* json,
                                          size_t json_size, size_t* length, char* why,
                                          size_t why_size) OPENEVC_NOEXCEPT;

/* ---- Braking curves and supervision limits (3.13) --------------------------------------------------------------- */

typedef struct openevc_curves openevc_curves;

OPENEVC_API size_t openevc_curves_size(void) OPENEVC_NOEXCEPT;
/* Traces the curves of a document `evc-curves/1` (docs/curves.md) of `length` bytes. `*curves` is then the object in
 * `memory`. Files that the document names are
 * read, from the working folder. */
OPENEVC_API openevc_result openevc_curves_build(void* memory, size_t memory_size, const char* document, size_t length,
                                                openevc_curves** curves, char* why, size_t why_size) OPENEVC_NOEXCEPT;

/* Metres in rear of the target location at which a curve or limit has a speed; negative beyond it. */
typedef struct openevc_distances {
  uint32_t size;
  uint32_t reserved;
  double A_safe, A_expected;             /* decelerations of EBD and SBD there, m/s2 */
  double EBD, SBD, GUI;                  /* the curves themselves */
  double EBI, SBI1, SBI2, FLOI, W, P, I; /* FLOI: the nearer one of SBI1 and SBI2 */
} openevc_distances;
OPENEVC_API openevc_result openevc_curves_at_speed(const openevc_curves* curves, double speed,
                                                   openevc_distances* distances) OPENEVC_NOEXCEPT;

/* Speeds of curves and limits at a place. */
typedef struct openevc_speeds {
  uint32_t size;
  uint32_t reserved;
  double EBD, SBD, EBI, SBI, W, P, I;
} openevc_speeds;
/* `position`: metres along the line, as in the document. */
OPENEVC_API openevc_result openevc_curves_at_position(const openevc_curves* curves, double position,
                                                      openevc_speeds* speeds) OPENEVC_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
