#ifndef OPENEVC_OPENEVC_H
#define OPENEVC_OPENEVC_H
/* The on-board unit, the braking curves and the ETCS language for programs in C and in languages that call C
 * (docs/embedding.md). Link libopenevc.so.0: `pkg-config --cflags --libs openevc`, or openevc::c of the CMake package.
 *
 * - Every object is in memory that the caller provides: OBJECT_size() bytes, aligned to openevc_alignment(). The
 *   library allocates nothing for it, keeps no pointer to the arguments of a call, and has no global state: one object
 *   is used by one thread at a time, different objects at the same time. To delete an object, free its memory.
 * - No exception is thrown. A function that can fail returns an `openevc_result` and, if `why` is not null, writes the
 *   error there: text in UTF-8, ended by a zero, cut to `why_size` bytes.
 * - The first member of a struct that a function takes is its size, set by the caller (openevc_inputs_init sets it, or
 *   `out.size = sizeof out`): a program compiled with an older header continues to work with a newer library, which
 *   neither reads nor writes beyond that size.
 * - Units are metres, seconds, m/s, m/s2. A number that does not exist is not a number (isnan).
 * - A member with the name of a variable of SUBSET-026-7 has its codes (NID_C, Q_TEXT, ...); modes and states of the
 *   unit have the numbers of the enumerations below.
 */
/* NOLINTBEGIN(modernize-deprecated-headers, modernize-use-using): C reads this too. */
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
  OPENEVC_BAD_ARGUMENT = 1, /* a null pointer, memory too small or not aligned, a struct whose size is not set, a number
                               that its member does not have */
  OPENEVC_TOO_SMALL = 2,    /* a buffer for a result is too small; the needed size is returned */
  OPENEVC_REFUSED = 3,      /* invalid text or bits, or a snapshot that does not fit */
  OPENEVC_NO_MEMORY = 4,    /* the heap is full: only where a text in JSON is read or written */
  OPENEVC_DEFECT = 5        /* a defect of the library */
} openevc_result;

/* "0.2.0", of the loaded library. */
OPENEVC_API const char* openevc_version(void) OPENEVC_NOEXCEPT;
/* Alignment of the memory of all objects, in bytes. */
OPENEVC_API size_t openevc_alignment(void) OPENEVC_NOEXCEPT;

/* ---- The on-board unit ------------------------------------------------------------------------------------------ */

typedef struct openevc_unit openevc_unit;

OPENEVC_API size_t openevc_unit_size(void) OPENEVC_NOEXCEPT;
/* `configuration`: the object `config` of docs/replay.md (cycle, SRS version, train, national values, levels), `length`
 * bytes; null or empty: the standard train. `*unit` becomes the object in `memory`, powered up: the first step
 * enters SB. Without `terminals` there is one mobile terminal, so that a program that does not name the RBC of messages
 * and reports has one session at a time (3.15.1.3.2); one that gives `radio_from`, `link_with` and reads `radio_out_to`
 * sets it to 2. */
OPENEVC_API openevc_result openevc_power_up(void* memory, size_t memory_size, const char* configuration, size_t length,
                                            openevc_unit** unit, char* why, size_t why_size) OPENEVC_NOEXCEPT;

typedef enum openevc_level {
  OPENEVC_L0 = 0,
  OPENEVC_NTC = 1,
  OPENEVC_L1 = 2,
  OPENEVC_L2 = 3,
  OPENEVC_L3 = 4
} openevc_level;

/* In the column order of 4.6.2. */
typedef enum openevc_mode {
  OPENEVC_NP = 0,
  OPENEVC_SB = 1,
  OPENEVC_PS = 2,
  OPENEVC_SH = 3,
  OPENEVC_FS = 4,
  OPENEVC_LS = 5,
  OPENEVC_SR = 6,
  OPENEVC_OS = 7,
  OPENEVC_SL = 8,
  OPENEVC_NL = 9,
  OPENEVC_UN = 10,
  OPENEVC_TR = 11,
  OPENEVC_PT = 12,
  OPENEVC_SF = 13,
  OPENEVC_IS = 14,
  OPENEVC_SN = 15,
  OPENEVC_RV = 16,
  OPENEVC_SM = 17, /* 4.0.0 */
  OPENEVC_AD = 18  /* 4.0.0 */
} openevc_mode;

/* Report of the radio bearer on the connection to an RBC. */
typedef enum openevc_link {
  OPENEVC_LINK_UNCHANGED = 0,
  OPENEVC_LINK_CONNECTED = 1,
  OPENEVC_LINK_LOST = 2,
  OPENEVC_LINK_REFUSED = 3
} openevc_link;

/* Selections of the driver in this cycle (4.7.2): `selected` has the bit 1u << openevc_select. */
typedef enum openevc_select {
  OPENEVC_START = 0,
  OPENEVC_OVERRIDE = 1,
  OPENEVC_SHUNTING = 2,
  OPENEVC_EXIT_SHUNTING = 3,
  OPENEVC_NON_LEADING = 4,
  OPENEVC_MAINTAIN_SHUNTING = 5,
  OPENEVC_TRAIN_DATA = 6,
  OPENEVC_SLIPPERY_RAIL = 7,
  OPENEVC_ADHESION_NORMAL = 8,
  OPENEVC_ISOLATE = 9,
  OPENEVC_TRACK_AHEAD_FREE = 10,
  OPENEVC_MAIN = 11, /* a button of the main window: ends some status texts */
  OPENEVC_INTEGRITY_CONFIRMED = 12,
  OPENEVC_LAST_RBC = 13,      /* the stored contact of an RBC is to be used (5.4.3.2 S3) */
  OPENEVC_SHORT_NUMBER = 14,  /* the short number stored on board is to be called (3.5.3.11) */
  OPENEVC_VBC_SET = 15,       /* a virtual balise cover is to be entered and set, or */
  OPENEVC_VBC_REMOVE = 16,    /* removed (3.15.9.2) */
  OPENEVC_RADIO_NETWORK = 17, /* the radio network is to be changed: sessions end (3.18.4.3.6) */
  OPENEVC_TOGGLE = 18,        /* speeds and distances in OS, SR and SH are switched on or off */
  OPENEVC_ATO_ENGAGE = 19,    /* 4.0.0: automatic driving is to be entered, or */
  OPENEVC_ATO_DISENGAGE = 20, /* left (4.4.16.1.2, .3) */
  OPENEVC_ASK_SM = 21,        /* 4.0.0: supervised manoeuvre is asked for, */
  OPENEVC_CONTINUE_SM = 22,   /* asked for again at its end (4.4.21.1.10), or */
  OPENEVC_EXIT_SM = 23,       /* left */
  OPENEVC_BMM_INHIBIT = 24,   /* 4.0.0: the reaction to the antenna alarm is inhibited (5.22), or */
  OPENEVC_BMM_REVOKE = 25     /* acts again */
} openevc_select;

/* Acknowledgements of the driver in this cycle, and those asked for: bit 1u << openevc_ack. */
typedef enum openevc_ack {
  OPENEVC_ACK_OS = 0,
  OPENEVC_ACK_LS = 1,
  OPENEVC_ACK_SH = 2,
  OPENEVC_ACK_SR = 3,
  OPENEVC_ACK_UN = 4,
  OPENEVC_ACK_SN = 5,
  OPENEVC_ACK_RV = 6,
  OPENEVC_ACK_TRIP = 7,
  OPENEVC_ACK_LEVEL = 8,
  OPENEVC_ACK_TEXT = 9,
  OPENEVC_ACK_BRAKE = 10,
  OPENEVC_ACK_TRAIN_DATA = 11
} openevc_ack;

/* Data of the driver (5.4): bit 1u << openevc_entry. */
typedef enum openevc_entry {
  OPENEVC_ENTRY_DRIVER_ID = 0,
  OPENEVC_ENTRY_LEVEL = 1,
  OPENEVC_ENTRY_RBC_CONTACT = 2,
  OPENEVC_ENTRY_TRAIN_DATA = 3,
  OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER = 4,
  OPENEVC_ENTRY_SR_SPEED = 5,    /* entered only, not asked for */
  OPENEVC_ENTRY_SR_DISTANCE = 6, /* the same */
  OPENEVC_ENTRY_VBC = 7,         /* the same */
  OPENEVC_ENTRY_NETWORK = 8,     /* the same */
  OPENEVC_ENTRY_SET_SPEED = 9,   /* the same */
  OPENEVC_ENTRY_LANGUAGE = 10    /* the same */
} openevc_entry;

/* What an external source says of the completeness of the train. */
typedef enum openevc_integrity {
  OPENEVC_INTEGRITY_UNKNOWN = 0,
  OPENEVC_INTEGRITY_OK = 1,
  OPENEVC_INTEGRITY_LOST = 2
} openevc_integrity;

/* Entry windows that are open: bit 1u << openevc_window. The train may not move (3.18.3.3.1, 4.4.11.1.5.1). */
typedef enum openevc_window { OPENEVC_WINDOW_TRAIN_DATA = 0, OPENEVC_WINDOW_SR_DATA = 1 } openevc_window;

/* Type of speed and distance monitoring (3.13.10). */
typedef enum openevc_monitoring {
  OPENEVC_MONITORING_NONE = 0,
  OPENEVC_CSM = 1,
  OPENEVC_TSM = 2,
  OPENEVC_RSM = 3
} openevc_monitoring;

/* Supervision status (3.13.10.1.2). */
typedef enum openevc_status {
  OPENEVC_STATUS_NONE = 0,
  OPENEVC_NORMAL = 1,
  OPENEVC_INDICATION = 2,
  OPENEVC_OVERSPEED = 3,
  OPENEVC_WARNING = 4,
  OPENEVC_INTERVENTION = 5
} openevc_status;

/* What the comparison of speed and limits comes to: the highest that holds. */
typedef enum openevc_memo {
  OPENEVC_MEMO_NULL = 0,
  OPENEVC_MEMO_P = 1,
  OPENEVC_MEMO_W = 2,
  OPENEVC_MEMO_SB = 3,
  OPENEVC_MEMO_EB = 4,
  OPENEVC_MEMO_TRIP = 5
} openevc_memo;

/* How far a session is (3.5.3 to 3.5.5). */
typedef enum openevc_phase {
  OPENEVC_SESSION_IDLE = 0,
  OPENEVC_SESSION_CONNECTING = 1,
  OPENEVC_SESSION_WAITING_VERSION = 2,
  OPENEVC_SESSION_UP = 3,
  OPENEVC_SESSION_LOST = 4,
  OPENEVC_SESSION_TERMINATING = 5
} openevc_phase;

/* The part of an RBC in a handover; without one it supervises (3.15.1). */
typedef enum openevc_role {
  OPENEVC_SUPERVISING = 0,
  OPENEVC_ACCEPTING = 1,   /* it will supervise beyond the border */
  OPENEVC_HANDING_OVER = 2 /* it supervised up to the border */
} openevc_role;

/* Kinds of track condition, with the codes of M_TRACKCOND (7.5.1.77). */
typedef enum openevc_condition_kind {
  OPENEVC_NON_STOPPING_AREA = 0,
  OPENEVC_TUNNEL_STOPPING_AREA = 1,
  OPENEVC_SOUND_HORN = 2,
  OPENEVC_POWERLESS_LOWER_PANTOGRAPH = 3,
  OPENEVC_RADIO_HOLE = 4,
  OPENEVC_AIR_TIGHTNESS = 5,
  OPENEVC_SWITCH_OFF_REGENERATIVE_BRAKE = 6,
  OPENEVC_SWITCH_OFF_EDDY_CURRENT_SERVICE_BRAKE = 7,
  OPENEVC_SWITCH_OFF_MAGNETIC_SHOE_BRAKE = 8,
  OPENEVC_POWERLESS_MAIN_SWITCH_OFF = 9,
  OPENEVC_SWITCH_OFF_EDDY_CURRENT_EMERGENCY_BRAKE = 10
} openevc_condition_kind;

/* How far a track condition has come (5.18). */
typedef enum openevc_condition_phase {
  OPENEVC_CONDITION_AHEAD = 0, /* not shown yet */
  OPENEVC_CONDITION_ANNOUNCED = 1,
  OPENEVC_CONDITION_ACTIVE = 2,
  OPENEVC_CONDITION_ENDING = 3, /* what it asked for is to be undone */
  OPENEVC_CONDITION_OVER = 4
} openevc_condition_phase;

/* Whether the engine was moved while the power was off, says cold movement detection (3.15.8). */
typedef enum openevc_movement {
  OPENEVC_MOVEMENT_UNKNOWN = 0,
  OPENEVC_NOT_MOVED = 1,
  OPENEVC_MOVED = 2
} openevc_movement;

/* An RBC by its identity, or a radio infill unit: then NID_RBC is NID_RIU. */
typedef struct openevc_rbc {
  uint16_t given; /* 0: none, the one that was called last */
  uint16_t NID_C, NID_RBC;
  uint16_t infill_unit; /* 1: a radio infill unit */
} openevc_rbc;

typedef struct openevc_telegram {
  const uint8_t* bytes; /* user bits, left aligned */
  uint32_t bits;        /* 0: something was read that is no telegram (3.16.2.4) */
  uint32_t reserved;
  double at; /* nominal counter when the antenna passed the balise's centre, metres */
} openevc_telegram;

typedef struct openevc_message {
  const uint8_t* bytes;
  size_t size;
} openevc_message;

/* At most so many telegrams, so many loop messages and so many radio messages in one cycle. */
#define OPENEVC_RECEIVED 64

/* The inputs of one cycle. Set the defaults with openevc_inputs_init, then fill it in. States (odometer, signals of the
 * train, national system) have to be given in every cycle; the other members are for one cycle. */
typedef struct openevc_consist_end {
  double nominal, min, max;
} openevc_consist_end;
typedef struct openevc_inputs {
  uint32_t size;
  int32_t link; /* openevc_link */
  double now;   /* seconds since power-up */
  /* The odometer: counters since power-up with nominal between min and max, speeds, acceleration. */
  double nominal, min, max;
  double V_est, V_min, V_max;
  double A_est;
  /* Data from trackside; read during the call only. */
  const openevc_telegram* telegrams;
  size_t telegrams_count;
  const openevc_message* loops;
  size_t loops_count;
  const openevc_message* radio;
  size_t radio_count;
  /* The driver. */
  uint32_t selected;             /* bits of openevc_select */
  uint32_t acknowledged;         /* bits of openevc_ack */
  uint32_t entered;              /* bits of openevc_entry: which of the following members are valid */
  uint32_t driver_id;            /* 8 BCD digits, if driver_id_text is empty */
  uint32_t train_running_number; /* 8 BCD digits */
  int32_t level;                 /* openevc_level */
  uint16_t NID_NTC;              /* with OPENEVC_NTC */
  uint16_t NID_C, NID_RBC;
  uint16_t acknowledged_text; /* with OPENEVC_ACK_TEXT: id of the message, 0: the oldest that waits */
  uint64_t NID_RADIO;         /* 16 BCD digits */
  double V_sr, D_sr;
  const char* train_data; /* docs/train.md, train_data_length bytes */
  size_t train_data_length;
  /* Signals of the train (SUBSET-034), 0 or 1. */
  uint8_t powered, isolated, desk_open, sleeping, non_leading, passive_shunting;
  int8_t direction; /* of the direction controller: -1 backward, 0 neutral, 1 forward */
  uint8_t service_brake_feedback;
  uint8_t regenerative_brake_active, eddy_current_brake_active, magnetic_shoe_brake_active, ep_brake_active;
  uint8_t additional_brake_active, safety_fault, national_trip;
  uint8_t cab;               /* whose desk is open: 0 cab A, 1 cab B */
  double brake_pressure_kpa; /* of the main pipe; not a number: not measured */
  uint64_t national_systems; /* bit n: the national system NID_NTC n is available */
  uint32_t open_windows;     /* bits of openevc_window: a state */
  /* 0 or 1: alarm of the balise antenna (3.15.7), brakes ordered by the national system (3.14.1.7.7). */
  uint8_t antenna_alarm, national_service_brake, national_emergency_brake;
  uint8_t external_data_trusted; /* 1: the driver does not validate external_train_data (5.17.2.2 D0) */
  /* Train data changed by another source than the driver, for one cycle: docs/train.md; null: none. */
  const char* external_train_data;
  size_t external_train_data_length;
  /* Train integrity by an external source (3.6.5.2), a state; the length of the train with it, not a number: not given.
   */
  int32_t integrity; /* openevc_integrity */
  /* 0 or 1, 4.0.0: automatic train operation asks for automatic driving; its selector is not in stand-by. */
  uint8_t ato_requests_AD, ato_active;
  uint16_t reserved_3;
  double length_confirmed;
  /* When the members of the odometer were measured, seconds since power-up; not a number: at `now`. The unit
   * extrapolates them by the speeds; older than 1 s while they show movement they count as failed. */
  double measured;
  /* Null, or for each of `telegrams` the time when the balise's centre was passed, in place of its `at`: the unit finds
   * the counter; where it is not a number, `at` counts. */
  const double* telegrams_passed;
  /* Null, or for each message of `radio` the RBC that it is from; where none is given: the RBC that was called last. */
  const openevc_rbc* radio_from;
  openevc_rbc link_with; /* the RBC of `link`; none given: the RBC that was called last */
  int32_t moved;         /* openevc_movement; counts in the cycle in which No Power is left */
  /* A virtual balise cover (3.15.9): its country, marker (0 to 63) and validity period in days. */
  uint16_t VBC_NID_C;
  uint8_t VBC_NID_VBCMK, VBC_T_VBC;
  uint32_t utc_given;       /* 1: `utc` is a reading of the clock in this cycle (3.18.5, 3.15.9.5) */
  uint32_t network;         /* NID_MN: 6 BCD digits, filled with F */
  int64_t utc;              /* seconds since 1970 */
  uint8_t radio_registered; /* 0 or 1, a state: a mobile terminal is registered with the radio network (3.5.6) */
  uint8_t reserved_4[7];
  double set_speed;        /* of the speed control, to be shown; 0: none any more */
  char driver_id_text[16]; /* up to 16 letters and digits, the rest zero */
  char language[8];        /* two letters of ISO 639-1: "en" */
  /* 4.0.0, safe consist length by an external source (3.18.3.2 b), a state: metres from the front end of the engine, on
   * the side of the active cab, to the ends of the shunting consist; the engine is part of what is in rear. All six are
   * given, min <= nominal <= max, or all are not a number: it is not available. */
  openevc_consist_end consist_front, consist_rear;
} openevc_inputs;
/* `size`: sizeof(openevc_inputs). Power is on, the direction is forward, the special brakes are active. */
OPENEVC_API openevc_result openevc_inputs_init(openevc_inputs* inputs, uint32_t size) OPENEVC_NOEXCEPT;

#define OPENEVC_SYMBOLS 32
#define OPENEVC_TEXTS 6
#define OPENEVC_RADIO_OUT 24
#define OPENEVC_EVENTS 96
#define OPENEVC_SESSIONS 2
#define OPENEVC_STATUS_TEXTS 20
#define OPENEVC_CONDITIONS 49
#define OPENEVC_AREAS 48
#define OPENEVC_PLATFORMS 40

typedef struct openevc_text {
  int32_t id;
  int32_t Q_TEXT; /* of a fixed text; -1: plain text */
  uint8_t length;
  uint8_t characters[255]; /* ISO 8859-1 */
} openevc_text;

typedef struct openevc_radio_out {
  uint32_t size;
  uint8_t bytes[192];
} openevc_radio_out;

typedef struct openevc_address {
  uint8_t given;       /* 0: none */
  uint8_t infill_unit; /* 1: a radio infill unit, NID_RBC is NID_RIU */
  uint8_t reserved[2];
  uint16_t NID_C, NID_RBC;
  uint64_t NID_RADIO;
} openevc_address;

typedef struct openevc_event {
  char text[128]; /* as in docs/replay.md: "mode SB->SR [8]", ended by a zero */
} openevc_event;

typedef struct openevc_session {
  uint16_t NID_C, NID_RBC;
  int32_t phase; /* openevc_phase */
} openevc_session;

/* How a text of the trackside is shown (3.12.3). */
typedef struct openevc_text_shown {
  double since;        /* when its display began */
  uint8_t important;   /* Q_TEXTCLASS */
  uint8_t acknowledge; /* the driver is asked to acknowledge it */
  uint8_t reserved[6];
} openevc_text_shown;

typedef struct openevc_status_shown {
  int32_t text;        /* openevc_status_text_name(text); its id is 256 + text */
  uint8_t acknowledge; /* the driver is asked to acknowledge it */
  uint8_t reserved[3];
  double since; /* when its display began */
} openevc_status_shown;

/* A track condition on the driver interface (5.18). */
typedef struct openevc_condition {
  char symbol[8];  /* as in `symbols` */
  int32_t kind;    /* openevc_condition_kind; -1: change of traction system */
  int32_t phase;   /* openevc_condition_phase */
  double from, to; /* nominal counters of a front end there; alike for a change at a place */
} openevc_condition;

/* Orders for the train (5.20, SUBSET-034): the distances that remain, metres from the front end. */
typedef struct openevc_area {
  int32_t kind; /* openevc_condition_kind: what is switched off, lowered or closed */
  uint32_t reserved;
  double to_start; /* below 0: in rear of the front end; not a number: not needed any more */
  double to_end;
} openevc_area;

typedef struct openevc_platform {
  double to_start; /* as of an area */
  double to_end;
  uint8_t M_PLATFORM, Q_PLATFORM;
  uint8_t reserved[6];
} openevc_platform;

typedef struct openevc_traction {
  uint8_t given; /* 0: no change is ordered */
  uint8_t M_VOLTAGE;
  uint16_t NID_CTRACTION;
  uint32_t reserved;
  double to_start;
} openevc_traction;

typedef struct openevc_current {
  uint32_t given;  /* 0: no change is ordered */
  int32_t amperes; /* -1: no restriction */
  double to_start;
} openevc_current;

/* Status of stored data (4.11). */
typedef enum openevc_data_status {
  OPENEVC_DATA_INVALID = 0,
  OPENEVC_DATA_VALID = 1,
  OPENEVC_DATA_UNKNOWN = 2
} openevc_data_status;

#define OPENEVC_COVERS 16

/* A virtual balise cover (3.15.9), and the time that is left of its validity, seconds. */
typedef struct openevc_cover {
  uint16_t NID_C;
  uint16_t NID_VBCMK;
  uint32_t T_VBC; /* days: the validity period as it was set */
  double left;
} openevc_cover;

/* Stored data (3.18.6), each status an openevc_data_status. A value counts where its status is valid; the driver may be
 * asked to revalidate an invalid one. */
typedef struct openevc_data {
  uint8_t driver_id_status, train_running_number_status;
  uint8_t level_status; /* of `level` */
  uint8_t rbc_status, train_status;
  uint8_t SR_status;     /* valid in SR */
  uint8_t slippery_rail; /* selected by the driver */
  uint8_t covers_count;
  uint32_t driver_id;            /* 8 BCD digits */
  uint32_t train_running_number; /* 8 BCD digits */
  openevc_address rbc;
  double L_TRAIN, V_MAXTRAIN;
  double brake_percentage; /* not a number with brake model gamma */
  uint16_t cant_deficiency_mm;
  uint16_t other_categories; /* 1 freight P, 2 freight G, 4 passenger */
  uint8_t M_AXLELOADCAT, M_LOADINGGAUGE;
  uint8_t airtight;
  uint8_t reserved;
  double V_sr, D_sr; /* supervised speed; what is left of the distance, not a number: infinite */
  openevc_cover covers[OPENEVC_COVERS];
} openevc_data;

#define OPENEVC_FORWARDED 8

/* Data of packet 44 for an application outside ETCS, or for a national system (3.15.6.5). */
typedef struct openevc_forwarded {
  uint16_t NID_XUSER;
  int16_t NID_NTC; /* -1: for no national system */
  uint16_t bits;
  uint16_t size;
  uint8_t bytes[128]; /* left aligned */
} openevc_forwarded;

/* What comes out of one cycle; members after `size` are written by openevc_step. */
typedef struct openevc_outputs {
  uint32_t size;
  int32_t mode;  /* openevc_mode */
  int32_t level; /* openevc_level */
  int32_t NID_NTC;
  int32_t LRBG_NID_C, LRBG_NID_BG; /* -1: no LRBG */
  int32_t monitoring;              /* openevc_monitoring */
  int32_t status;                  /* openevc_status */
  double now;
  double est_front, min_safe_front, max_safe_front; /* as nominal counters */
  double V_est;
  /* Not a number where not supervised. */
  double V_P, V_W, V_SBI, V_EBI, V_MRSP, V_target, V_release;
  double d_target;
  double EOA, SvL; /* nominal counter of a front end at that place */
  /* Commands: traction cut-off, service brake, emergency brake. */
  uint8_t tco, sb, eb;
  uint8_t start_offered; /* the driver may select OPENEVC_START */
  uint32_t requests;     /* bits of openevc_ack: acknowledgements asked of the driver */
  uint32_t entries;      /* bits of openevc_entry: data asked of the driver */
  uint32_t symbols_count, texts_count, radio_out_count, events_count;
  uint64_t brake_causes;            /* bit n: openevc_cause_name(n) asks for a brake */
  char symbols[OPENEVC_SYMBOLS][8]; /* names of ERA_ERTMS_015560: "MO07", ended by a zero */
  openevc_text texts[OPENEVC_TEXTS];
  openevc_address connect, disconnect;
  openevc_radio_out radio_out[OPENEVC_RADIO_OUT];
  openevc_event events[OPENEVC_EVENTS];
  /* Not a number where there is none. */
  double V_I;
  double TTI; /* seconds */
  double LSSMA;
  double d_indication;
  double geo;     /* geographical position of the front end, metres */
  double rv_left; /* metres */
  uint8_t MRDT_changed;
  uint8_t level_valid;
  uint8_t levels_allowed; /* bit 1u << openevc_level */
  uint8_t reserved;
  int32_t memo_status; /* openevc_memo; -1 where speed is not supervised */
  int32_t trip_reason; /* openevc_status_text_name(trip_reason); -1: none */
  uint32_t sessions_count;
  uint64_t status_texts; /* bit n: openevc_status_text_name(n) is shown */
  uint64_t enabled;      /* bit n: openevc_input_name(n) is enabled */
  openevc_session sessions[OPENEVC_SESSIONS];
  int32_t sessions_role[OPENEVC_SESSIONS];       /* openevc_role of each of `sessions` */
  openevc_text_shown texts_shown[OPENEVC_TEXTS]; /* of each of `texts` */
  openevc_rbc radio_out_to[OPENEVC_RADIO_OUT];   /* of each of `radio_out`; none given: the RBC that supervises */
  uint32_t statuses_count, conditions_count, areas_count, platforms_count;
  openevc_status_shown statuses[OPENEVC_STATUS_TEXTS]; /* those of `status_texts`, in the order of their display */
  openevc_condition conditions[OPENEVC_CONDITIONS];
  openevc_area areas[OPENEVC_AREAS];
  openevc_platform platforms[OPENEVC_PLATFORMS];
  openevc_traction traction;
  openevc_current current;
  uint8_t sound_horn;      /* the driver is asked for it */
  uint8_t remote_shunting; /* the mode permits it (4.4.8.1.4) */
  uint8_t M_VERSION;       /* operated system version (3.17.2): X in bits 4 to 6, Y in bits 0 to 3 */
  /* 4.0.0, in SM: 1 the engine is oriented as the direction of the authority, -1 opposite to it; 0: not in SM
   * (4.4.21.1.13) */
  int8_t engine_orientation;
  /* NID_MN of the network with which free mobile terminals have to register now (3.5.6), 0xFFFFFF: their own default;
   * -1: no order. */
  int32_t radio_register;
  /* Sessions with radio infill units, NID_RBC is NID_RIU; those with RBCs are `sessions`. */
  uint32_t infill_sessions_count;
  uint32_t reserved_3;
  openevc_session infill_sessions[OPENEVC_SESSIONS];
  openevc_data data;
  int64_t utc;              /* date and time, seconds since 1970 (3.18.5) */
  int32_t local_offset_min; /* of the local time from UTC */
  uint32_t utc_given;       /* 0: not known */
  uint32_t forwarded_count;
  uint32_t reserved_4;
  openevc_forwarded forwarded[OPENEVC_FORWARDED]; /* accepted in this cycle */
  int32_t dialogue;             /* openevc_dialogue(dialogue): what a procedure waits for; -1: nothing */
  int32_t dialogue_acknowledge; /* openevc_ack, where that is an acknowledgement; -1: another thing */
  uint64_t shown;          /* bit n: openevc_output_name(n) is shown to the driver in this mode (SUBSET-026-4 4.7.2) */
  double set_speed;        /* as entered, where the mode shows it; not a number: none */
  int32_t network;         /* NID_MN of the radio network, of trackside or driver, or the default; -1: not known */
  int32_t national_system; /* NID_NTC of the last level NTC, which status texts speak of; -1: none yet */
  char language[8];        /* of the display: "en" */
  char driver_id_text[24]; /* of `data`: up to 16 letters and digits, ended by a zero */
} openevc_outputs;

/* One cycle (docs/replay.md). With OPENEVC_OK the unit has made its step and `outputs` has all of it. With any other
 * result, its reason in `why`, the unit and `outputs` are unchanged: the call may be repeated. Data from trackside and
 * odometer are never refused here: the unit handles them by the rules of the standard. The heap is used only to read
 * `train_data` and `external_train_data`, before the step: without them OPENEVC_NO_MEMORY is never returned. From the
 * beginning of the step on nothing is allocated and nothing can fail, so that a brake command reaches the caller. */
OPENEVC_API openevc_result openevc_step(openevc_unit* unit, const openevc_inputs* inputs, openevc_outputs* outputs,
                                        char* why, size_t why_size) OPENEVC_NOEXCEPT;

/* What a step of the most restrictive speed profile comes from (3.13.7): bit 1u << openevc_mrsp_source. */
typedef enum openevc_mrsp_source {
  OPENEVC_MRSP_SSP = 0,
  OPENEVC_MRSP_ASP = 1,
  OPENEVC_MRSP_TSR = 2,
  OPENEVC_MRSP_PBD = 3,
  OPENEVC_MRSP_LX = 4,
  OPENEVC_MRSP_SIGNALLING = 5,
  OPENEVC_MRSP_TRAIN = 6,
  OPENEVC_MRSP_MODE = 7,
  OPENEVC_MRSP_OVERRIDE = 8
} openevc_mrsp_source;

#define OPENEVC_PLANNED_SPEEDS 128
#define OPENEVC_PLANNED_GRADIENTS 96
#define OPENEVC_PLANNED_CONDITIONS 97

typedef struct openevc_planned_speed {
  double at; /* of the first one 0: it is in force */
  double V;
  uint32_t sources; /* bits of openevc_mrsp_source */
  uint32_t reserved;
} openevc_planned_speed;

typedef struct openevc_planned_gradient {
  double from, to;
  int32_t permille; /* positive uphill */
  uint32_t reserved;
} openevc_planned_gradient;

typedef struct openevc_planned_condition {
  char symbol[8]; /* as in `symbols`: "PL02" */
  int32_t kind;   /* openevc_condition_kind; -1: change of traction system */
  uint32_t reserved;
  double at;
} openevc_planned_condition;

/* The advance display of route related information (3.15.10): distances from the front end, the min safe, the estimated
 * or the max safe one, as each is supervised. The first Indication location is d_indication of openevc_outputs. */
typedef struct openevc_planning {
  uint32_t size;
  uint32_t given; /* 0: none, in another mode than FS and OS or without an authority */
  uint32_t speeds_count, gradients_count, conditions_count;
  uint32_t reserved;
  double EOA, LOA, V_LOA; /* not a number: none, or beyond a speed of zero */
  openevc_planned_speed speeds[OPENEVC_PLANNED_SPEEDS];
  openevc_planned_gradient gradients[OPENEVC_PLANNED_GRADIENTS];
  openevc_planned_condition conditions[OPENEVC_PLANNED_CONDITIONS];
} openevc_planning;

/* The advance display after the last step, computed now; `planning->size` is set by the caller. After openevc_restore
 * there is none until the next step. */
OPENEVC_API openevc_result openevc_plan(openevc_unit* unit, openevc_planning* planning) OPENEVC_NOEXCEPT;

/* What a driver-machine interface of ERA_ERTMS_015560 shows (docs/replay.md, "The record of the display"): masked by
 * the mode (4.7.2), whether the driver has toggled it on or not. Distances are from the estimated front end. A symbol
 * is its name in 015560 13, ended by a zero: "TC03". What is fixed for a display, as the languages and the limits of
 * entries, is the host's; what is to be entered has the status of `data`. */
#define OPENEVC_DISPLAYED_CONDITIONS 50
#define OPENEVC_PLANNED_ORDERS 97
#define OPENEVC_DISPLAYED_TEXTS 32
#define OPENEVC_ASKED 32
#define OPENEVC_NATIONAL_SYSTEMS 16
#define OPENEVC_NETWORKS 16

/* The highest speed of the dial, km/h (015560 8.2.1.1). */
typedef enum openevc_dial {
  OPENEVC_DIAL_140 = 0,
  OPENEVC_DIAL_180 = 1,
  OPENEVC_DIAL_250 = 2,
  OPENEVC_DIAL_400 = 3
} openevc_dial;

/* The symbol of the radio connection (area E1). */
typedef enum openevc_radio_indication {
  OPENEVC_RADIO_NOT_SHOWN = 0,
  OPENEVC_RADIO_FAILED = 1,
  OPENEVC_RADIO_UP = 2
} openevc_radio_indication;

typedef enum openevc_text_kind {
  OPENEVC_TEXT_FIXED = 0,
  OPENEVC_TEXT_PLAIN = 1,
  OPENEVC_TEXT_STATUS = 2,
  OPENEVC_TEXT_NATIONAL = 3
} openevc_text_kind;

/* For what the display shows the hour glass (015560 11.7). */
typedef enum openevc_waiting {
  OPENEVC_WAITING_NOTHING = 0,
  OPENEVC_WAITING_END_OF_SESSION = 1,
  OPENEVC_WAITING_RADIO_REGISTRATION = 2,
  OPENEVC_WAITING_NETWORK_LIST = 3,
  OPENEVC_WAITING_SESSION = 4,
  OPENEVC_WAITING_TRAIN_ACCEPTED = 5,
  OPENEVC_WAITING_TRAIN_DATA_ACKNOWLEDGED = 6,
  OPENEVC_WAITING_ANSWER_TO_MA_REQUEST = 7,
  OPENEVC_WAITING_ANSWER_TO_SH_REQUEST = 8,
  OPENEVC_WAITING_ANSWER_TO_SM_REQUEST = 9
} openevc_waiting;

/* A symbol of areas B3 to B5, in the order of appearance. */
typedef struct openevc_displayed_condition {
  char symbol[8];
  int32_t phase; /* openevc_condition_phase */
  uint32_t id;   /* the same as long as it is the same condition */
} openevc_displayed_condition;

/* A symbol of the planning area (015560 8.3.4). */
typedef struct openevc_planned_order {
  char symbol[8];
  double at;
} openevc_planned_order;

/* A text of areas E5 to E9 (015560 8.2.3.4). */
typedef struct openevc_displayed_text {
  uint16_t id;
  uint8_t kind;          /* openevc_text_kind */
  uint8_t important;     /* group 1 */
  uint8_t acknowledge;   /* it is to be acknowledged, and was not yet */
  uint8_t Q_TEXT;        /* of a fixed text */
  uint8_t NID_NTC;       /* of a status text that names a national system */
  uint8_t length;        /* of a plain or national text */
  int32_t status;        /* openevc_status_text_name(status); -1: another kind */
  int32_t minute_of_day; /* local time of its begin; -1: not known */
  double since;
  uint8_t characters[256]; /* ISO 8859-1 */
} openevc_displayed_text;

/* What the driver has to acknowledge, in the order of arrival. */
typedef struct openevc_asked {
  int32_t what; /* openevc_ack */
  uint32_t id;  /* with OPENEVC_ACK_TEXT: of the text */
  double since;
} openevc_asked;

typedef struct openevc_display {
  uint32_t size;
  int32_t mode;  /* openevc_mode; OPENEVC_NP: nothing is shown */
  int32_t level; /* openevc_level, where level_valid */
  int32_t dial;  /* openevc_dial */
  double now;
  int32_t second_of_day; /* local time; -1: not known or not shown */
  uint8_t level_valid;
  uint8_t NID_NTC; /* with level NTC */
  uint8_t standstill;
  uint8_t MRDT;     /* changes when another target is the most relevant displayed one */
  char language[8]; /* "en" */
  /* Areas A and B. Not a number: not shown. */
  double V, V_P, V_SBI, V_target, V_release;
  double d_target, TTI, LSSMA, set_speed;
  double T_dispTTI;   /* TTI is shown below it (A.3.1) */
  int32_t monitoring; /* openevc_monitoring */
  int32_t status;     /* openevc_status */
  /* 0 or 1. */
  uint8_t target_information; /* in CSM the target is shown */
  uint8_t slippery_rail, override_active, reversing_permitted, bmm_inhibited, track_ahead_free;
  uint8_t brake;
  uint8_t brake_for_missing_ack; /* it is released by the acknowledgement of a level, mode or text */
  uint8_t announced, announced_NID_NTC;
  uint8_t tunnel;                /* a tunnel stopping area is known; */
  uint8_t tunnel_inside;         /* the front end is in it */
  int8_t SM_direction;           /* 4.0.0: -1 backward, 1 forward, 0 not shown */
  uint8_t ato_on;                /* 4.0.0: the ATO selector is not in stand-by */
  uint8_t start_of_mission;      /* its dialogue runs, up to the Main window */
  uint8_t asks_brake_percentage; /* 0: the train has brake model gamma */
  int32_t announced_level;       /* openevc_level */
  int32_t radio;                 /* openevc_radio_indication */
  double tunnel_distance;
  double geo; /* metres */
  uint32_t conditions_count, orders_count, texts_count, asked_count, national_systems_count, networks_count;
  openevc_displayed_condition conditions[OPENEVC_DISPLAYED_CONDITIONS];
  openevc_planned_order orders[OPENEVC_PLANNED_ORDERS];
  double indication_marker, indication_target; /* the first Indication location; the place of its target */
  openevc_displayed_text texts[OPENEVC_DISPLAYED_TEXTS];
  openevc_asked asked[OPENEVC_ASKED];
  /* The driver's side. */
  uint64_t buttons;        /* bit n: openevc_button_name(n) is enabled, but for an acknowledgement that is pending */
  uint64_t enabled;        /* bit n: openevc_input_name(n) is enabled */
  int32_t step;            /* openevc_dialogue(step); -1: none */
  int32_t waiting;         /* openevc_waiting */
  openevc_data data;       /* stored data as the mode shows them */
  char driver_id_text[24]; /* of `data` */
  int32_t network;         /* NID_MN; -1: not known or not shown */
  uint8_t levels;          /* that the driver may choose: bit 1u << openevc_level */
  uint8_t M_VERSION;       /* operated system version, as in openevc_outputs */
  uint8_t radio_registered;
  uint8_t national_systems[OPENEVC_NATIONAL_SYSTEMS]; /* NID_NTC that the driver may choose */
  uint8_t reserved;
  uint32_t networks[OPENEVC_NETWORKS]; /* NID_MN that the driver may choose */
  double D_sr_most;                    /* the longest SR distance that is proposed; not a number: none */
  openevc_planning planning;           /* of it `speeds`, `gradients`, EOA and LOA; its conditions are `orders` */
} openevc_display;

/* The record after the last step, made now; `display->size` is set by the caller. After openevc_power_up and
 * openevc_restore there is none until the next step: its mode is OPENEVC_NP. */
OPENEVC_API openevc_result openevc_show(openevc_unit* unit, openevc_display* display) OPENEVC_NOEXCEPT;
/* "Train running number", the label in English of a button of 015560 11.2; null where there is none of that number. */
OPENEVC_API const char* openevc_button_name(int32_t button) OPENEVC_NOEXCEPT;

/* "overspeed: SBI"; null if there is no cause with this number. */
OPENEVC_API const char* openevc_cause_name(int32_t cause) OPENEVC_NOEXCEPT;

/* "SR distance exceeded" and "rbc_contact" (the inputs of SUBSET-026-4 4.7.2); null where there is none of that number.
 */
OPENEVC_API const char* openevc_status_text_name(int32_t text) OPENEVC_NOEXCEPT;
OPENEVC_API const char* openevc_input_name(int32_t input) OPENEVC_NOEXCEPT;
/* "permitted_speed" (the outputs of SUBSET-026-4 4.7.2). */
OPENEVC_API const char* openevc_output_name(int32_t output) OPENEVC_NOEXCEPT;

/* A step of a procedure of SUBSET-026-5: "start_of_mission", "S12", "train_data"; waits_for is "ack" where it is an
 * acknowledgement of the driver. Nulls where there is none of that number. */
typedef struct openevc_dialogue_words {
  const char *procedure, *step, *waits_for;
} openevc_dialogue_words;
OPENEVC_API openevc_dialogue_words openevc_dialogue(int32_t dialogue) OPENEVC_NOEXCEPT;

/* A snapshot is all that a unit remembers, as bytes with a head that says what made it. One that another layout of the
 * unit has made, or that is damaged, is refused: OPENEVC_REFUSED, and the unit is as it was. */
OPENEVC_API size_t openevc_snapshot_size(void) OPENEVC_NOEXCEPT;
OPENEVC_API openevc_result openevc_snapshot(const openevc_unit* unit, void* snapshot, size_t size) OPENEVC_NOEXCEPT;
/* `memory` as for openevc_power_up; it may be that of `*unit` itself. */
OPENEVC_API openevc_result openevc_restore(void* memory, size_t memory_size, const void* snapshot, size_t size,
                                           openevc_unit** unit, char* why, size_t why_size) OPENEVC_NOEXCEPT;

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
  int32_t to_track;  /* of a message or packet: 1 from the train to the track, 0 to the train */
  uint8_t version_x; /* system version X.Y of the session, for a message or packet; 0.0: 2.1 */
  uint8_t version_y;
  uint8_t tolerant; /* 1: spare codes are accepted too */
  uint8_t reserved;
} openevc_reading;

/* The JSON text (docs/decode.md) of the first `bits` bits of `bytes`, left aligned. `json` gets the text with a zero
 * at its end; `length`, if not null, its length without the zero, also with OPENEVC_TOO_SMALL. */
OPENEVC_API openevc_result openevc_decode(const openevc_reading* reading, const uint8_t* bytes, size_t bits, char* json,
                                          size_t json_size, size_t* length, char* why,
                                          size_t why_size) OPENEVC_NOEXCEPT;

/* ---- Braking curves and supervision limits (3.13) --------------------------------------------------------------- */

typedef struct openevc_curves openevc_curves;

OPENEVC_API size_t openevc_curves_size(void) OPENEVC_NOEXCEPT;
/* Traces the curves of a document `evc-curves/1` (docs/curves.md) of `length` bytes. `*curves` becomes the object in
 * `memory`. Files named in the document are read from the working folder. */
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

/* Speeds of curves and limits for a train whose estimated front end is at a place; the limits with their ceilings
   (3.13.9.2) and floors (3.13.9.3.3.7, 3.13.9.3.5.7). */
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
/* NOLINTEND(modernize-deprecated-headers, modernize-use-using) */
#endif
