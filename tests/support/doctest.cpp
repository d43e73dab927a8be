// The implementation of doctest, once for everything that links the support library: also for
// programs with a main function of their own.
// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
