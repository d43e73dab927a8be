// The names of trace events.
// SPDX-License-Identifier: MIT
#include "core/trace.h"

namespace trellis {

std::string_view name_of(TraceEvent::Kind kind) {
    static constexpr std::string_view names[] = {"status", "tick",       "halt",  "skip", "enter",
                                                 "leave",  "transition", "event", "log",  "error"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace trellis
