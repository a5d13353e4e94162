// `evc replay` and nothing else: what tools/check_determinism builds with every compiler and level.
#include <cstdio>
#include <cstring>

#include "run/replay.h"

int main(int argc, char** argv) {
  if (argc != 5 || std::strcmp(argv[1], "replay") != 0 || std::strcmp(argv[3], "-o") != 0) {
    std::fputs("usage: evc_replay replay INPUTS -o OUTPUTS\n", stderr);
    return 2;
  }
  evc::run::ReplayOptions options;
  options.input = argv[2];
  options.output = argv[4];
  return evc::run::replay(options);
}
