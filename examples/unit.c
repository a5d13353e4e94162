/* A minute of an on-board unit in C; the same as examples/unit.cpp, and it prints the same. */
#include <openevc/openevc.h>
#include <stdio.h>
#include <stdlib.h>

static const double cycle_s = 0.1;

/* Actions of the driver in cycle n. */
static void drive(openevc_inputs* in, int n) {
  if (n == 10) {
    in->entered = 1u << OPENEVC_ENTRY_DRIVER_ID;
    in->driver_id = 0x00001234;
  }
  if (n == 20) {
    in->entered = 1u << OPENEVC_ENTRY_LEVEL;
    in->level = OPENEVC_L0;
  }
  if (n == 30) in->selected = 1u << OPENEVC_TRAIN_DATA;
  if (n == 40) {
    static const char standard[] = "{\"schema\":\"etcs-train/1\"}";
    in->entered = 1u << OPENEVC_ENTRY_TRAIN_DATA;
    in->train_data = standard;
    in->train_data_length = sizeof standard - 1;
  }
  if (n == 50) {
    in->entered = 1u << OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER;
    in->train_running_number = 0x00004711;
  }
  if (n == 60) in->selected = 1u << OPENEVC_START;
  if (n > 60) in->acknowledged = 1u << OPENEVC_ACK_UN;
}

/* The odometer of a train that is at standstill for ten seconds, then gains 0.5 m/s every second; error at most 1 %. */
static void count(openevc_inputs* in, int n) {
  const double t = n > 100 ? (n - 100) * cycle_s : 0.0;
  in->V_est = 0.5 * t;
  in->V_min = 0.99 * in->V_est;
  in->V_max = 1.01 * in->V_est;
  in->nominal = 0.25 * t * t;
  in->min = 0.99 * in->nominal;
  in->max = 1.01 * in->nominal;
  in->A_est = t > 0.0 ? 0.5 : 0.0;
}

static const char* mode_name(int mode) {
  static const char* names[] = {"NP", "SB", "PS", "SH", "FS", "LS", "SR", "OS", "SL",
                                "NL", "UN", "TR", "PT", "SF", "IS", "SN", "RV"};
  return names[mode];
}

static const char* level_name(int level) {
  static const char* names[] = {"0", "NTC", "1", "2", "3"};
  return names[level];
}

int main(void) {
  const size_t alignment = openevc_alignment();
  const size_t size = (openevc_unit_size() + alignment - 1) / alignment * alignment;
  void* memory = aligned_alloc(alignment, size);
  void* snapshot = malloc(openevc_snapshot_size());
  openevc_outputs* out = malloc(sizeof *out);
  openevc_unit* unit = NULL;
  char why[256];
  int n;
  if (memory == NULL || snapshot == NULL || out == NULL) return 2;
  if (openevc_power_up(memory, size, NULL, 0, &unit, why, sizeof why) != OPENEVC_OK) {
    fprintf(stderr, "%s\n", why);
    return 2;
  }
  out->size = sizeof *out;
  printf("%5s %4s %5s %8s %9s %6s\n", "s", "mode", "level", "km/h", "m", "brakes");
  for (n = 0; n <= 600; ++n) {
    openevc_inputs in;
    openevc_inputs_init(&in, sizeof in);
    in.now = n * cycle_s;
    count(&in, n);
    in.desk_open = n > 0;
    drive(&in, n);
    if (openevc_step(unit, &in, out, why, sizeof why) != OPENEVC_OK) {
      fprintf(stderr, "cycle %d: %s\n", n, why);
      return 2;
    }
    if (n % 50 == 0)
      printf("%5.1f %4s %5s %8.3f %9.3f %6s\n", out->now, mode_name(out->mode), level_name(out->level),
             out->V_est * 3.6, out->est_front, out->eb ? "EB" : out->sb ? "SB" : "-");
    if (n == 300) { /* a restored unit continues from the snapshot */
      if (openevc_snapshot(unit, snapshot, openevc_snapshot_size()) != OPENEVC_OK) return 1;
      if (openevc_restore(memory, size, snapshot, openevc_snapshot_size(), &unit, why, sizeof why) != OPENEVC_OK)
        return 1;
    }
  }
  free(out);
  free(snapshot);
  free(memory);
  return 0;
}
