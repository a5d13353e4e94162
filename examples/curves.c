/* Braking curves in C: the document in the file that is named (docs/curves.md) to a table of metres before its target.
 * The numbers are those of examples/curves.cpp for data/curves/passenger_eoa.json. */
#include <openevc/openevc.h>
#include <stdio.h>
#include <stdlib.h>

static char* text_of(const char* name, size_t* length) {
  FILE* file = fopen(name, "rb");
  char* text = NULL;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && ftell(file) > 0) {
    *length = (size_t)ftell(file);
    rewind(file);
    text = malloc(*length);
    if (text != NULL && fread(text, 1, *length, file) != *length) *length = 0;
  }
  fclose(file);
  return text;
}

int main(int argc, char** argv) {
  size_t length = 0;
  char why[256];
  char* document = argc > 1 ? text_of(argv[1], &length) : NULL;
  /* Memory is ours; its size a multiple of the alignment, as aligned_alloc wants it. */
  const size_t alignment = openevc_alignment();
  const size_t size = (openevc_curves_size() + alignment - 1) / alignment * alignment;
  void* memory = aligned_alloc(alignment, size);
  openevc_curves* curves = NULL;
  int kmh;
  if (document == NULL || memory == NULL) {
    fprintf(stderr, "usage: curves FILE (evc-curves/1)\n");
    return 2;
  }
  if (openevc_curves_build(memory, size, document, length, &curves, why, sizeof why) != OPENEVC_OK) {
    fprintf(stderr, "%s\n", why);
    return 2;
  }
  free(document);
  printf("metres before the end of authority\n%6s %9s %9s %9s %9s %9s\n", "km/h", "EBD", "EBI", "SBI", "P", "I");
  for (kmh = 20; kmh <= 160; kmh += 20) {
    openevc_distances d = {.size = sizeof d};
    if (openevc_curves_at_speed(curves, kmh / 3.6, &d) != OPENEVC_OK) return 1;
    printf("%6d %9.1f %9.1f %9.1f %9.1f %9.1f\n", kmh, d.EBD, d.EBI, d.FLOI, d.P, d.I);
  }
  free(memory);
  return 0;
}
