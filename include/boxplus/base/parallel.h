// SPDX-License-Identifier: BSD-3-Clause
// The fork-join pool of boxplus.
#pragma once

#include "boxplus/base/abi.h"
#include "boxplus/base/function_ref.h"

namespace boxplus::detail {

/// Number of hardware threads, at least 1.
int hardware_threads() noexcept;

/// Runs task(0) … task(count − 1), task i on worker i (worker 0 is the caller), and returns when all tasks
/// have ended. When the caller has run task 0, it also runs the tasks that no worker has begun. So a machine
/// whose processors are busy with other programs delays only the tasks that have begun.
///
/// The whole process shares the workers. They start on first use, spin for 50 µs after their last task, then
/// sleep. A call allocates nothing if `count` workers exist. Calls from several threads run one after the
/// other. A call from inside a task runs its tasks in order on the calling worker. If the system grants fewer
/// threads, the caller runs the remaining tasks. Therefore, the tasks of one call must not wait for each
/// other.
///
/// Tasks compute in the floating-point mode of the caller (rounding, subnormal numbers), on any thread.
///
/// All tasks run, even if some of them throw. Then the first exception in the order of the tasks is rethrown.
void parallel_tasks(int count, FunctionRef<void(int)> task);

}  // namespace boxplus::detail
