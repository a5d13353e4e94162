#pragma once
#include "modes/mode.h"
