// A program that uses an installed Trellis through its public headers only; exit 0 means that they
// are found and that their includes of each other are. Built and run by tests/consumer.
// SPDX-License-Identifier: MIT
#include <trellis/core/ids.h>

int main() {
    return trellis::RowId{} ? 1 : 0;
}
