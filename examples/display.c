/* What the driver sees and may touch: the record of the display (ERA_ERTMS_015560) of a unit whose desk is opened. */
#include <openevc/openevc.h>
#include <stdio.h>
#include <stdlib.h>

static void print(const openevc_display* shown) {
  const openevc_dialogue_words step = openevc_dialogue(shown->step);
  int32_t n;
  printf("%4.1f s: mode %d, %.0f km/h, step %s, buttons:", shown->now, (int)shown->mode, shown->V * 3.6,
         step.step != NULL ? step.step : "-");
  for (n = 0; openevc_button_name(n) != NULL; ++n)
    if (shown->buttons >> n & 1u) printf(" [%s]", openevc_button_name(n));
  printf("\n");
}

int main(void) {
  const size_t alignment = openevc_alignment();
  const size_t size = (openevc_unit_size() + alignment - 1) / alignment * alignment;
  void* memory = aligned_alloc(alignment, size);
  openevc_outputs* out = malloc(sizeof *out);
  openevc_display* shown = malloc(sizeof *shown);
  openevc_unit* unit = NULL;
  char why[256];
  int n;
  if (memory == NULL || out == NULL || shown == NULL) return 2;
  if (openevc_power_up(memory, size, NULL, 0, &unit, why, sizeof why) != OPENEVC_OK) {
    fprintf(stderr, "%s\n", why);
    return 2;
  }
  out->size = sizeof *out;
  shown->size = sizeof *shown;
  for (n = 0; n <= 50; ++n) {
    openevc_inputs in;
    openevc_inputs_init(&in, sizeof in);
    in.now = n * 0.1;
    in.desk_open = n >= 10;
    if (n == 30) { /* the driver's identity, as the display would send it */
      in.entered = 1u << OPENEVC_ENTRY_DRIVER_ID;
      in.driver_id = 0x1234FFFF;
    }
    if (openevc_step(unit, &in, out, why, sizeof why) != OPENEVC_OK) {
      fprintf(stderr, "cycle %d: %s\n", n, why);
      return 2;
    }
    if (n % 10 == 0) {
      if (openevc_show(unit, shown) != OPENEVC_OK) return 1;
      print(shown);
    }
  }
  free(shown);
  free(out);
  free(memory);
  return 0;
}
