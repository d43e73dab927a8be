// Reads the recorded runs of the Python lab in TRELLIS_SHARED_DIR/lab: the angles of each run, the
// rows where something changed, and four runs whole (through `xz -dc`). Reads only; the comparison
// is the test's. Covered by tests/sim/lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"
#include "support/lab_reference.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// One list of angles and the world its runs start in.
struct LabStream {
    std::string name;  ///< "r00", "t00_fwd_tie_bt"
    LabWorld world;
    std::vector<double> angles;  ///< rad, of the 1st, 2nd, … Rotate
};

/// The ticks that every recorded run has.
inline constexpr std::int64_t lab_ticks = 36'000;

/// All streams, sorted by name; empty, after a message, where the shared folder is absent.
std::vector<LabStream> lab_streams();

/// The recorded rows at which leaf or bumper change, and every 600 ticks, of one stream; `kind` is
/// "fsm" or "bt". Empty if there is no such recording.
std::vector<LabRow> lab_events(std::string_view kind, std::string_view stream);

/// Every recorded row of one stream; empty if it was not recorded whole or, after a message, if
/// there is no xz to unpack it.
std::vector<LabRow> lab_whole_run(std::string_view kind, std::string_view stream);

}  // namespace trellis::test
