// Instructions for keys, displays and knobs: F70-F75, F77, F85, F86, F89.
#pragma once

#include "ladder/tp03/ops/keys.h"
#include "ladder/tp03/ops/potentiometer.h"
#include "ladder/tp03/ops/print.h"
#include "ladder/tp03/ops/segments.h"
