// Threads that take numbers from a counter.
// SPDX-License-Identifier: MIT
#include "runner/sweep/crew.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace trellis {

void share_out(std::size_t count, unsigned threads, const std::function<bool(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stopped = false;
    std::mutex failing;
    std::exception_ptr failure;
    const auto take = [&] {
        try {
            while (!stopped) {
                const std::size_t i = next++;
                if (i >= count) return;
                if (!work(i)) stopped = true;
            }
        } catch (...) {
            const std::lock_guard lock(failing);
            failure = std::current_exception();
            stopped = true;
        }
    };
    // this thread is one of them
    const std::size_t others = std::min<std::size_t>(std::max(1U, threads), count);
    std::vector<std::thread> crew;
    for (std::size_t i = 1; i < others; ++i)
        crew.emplace_back(take);
    take();
    for (std::thread& thread : crew)
        thread.join();
    if (failure) std::rethrow_exception(failure);
}

unsigned machine_threads() {
    return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace trellis
