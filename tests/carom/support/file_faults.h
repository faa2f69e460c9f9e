#pragma once

/// Faults of the file system, put in on purpose.
namespace carom::test {

enum class FileFault { none, full_disk, death };

/// Makes the `number`th call (from 1) of write(), fchmod(), fsync(), rename(), mkostemps(),
/// mkdir(), flock() or unlink() fail as on a full disk, or end the process before it takes effect.
/// A write that fails has written half. Calls from the C library's own streams are not counted.
/// `none` counts from anew without a fault.
void set_file_fault(FileFault fault, int number);
/// Calls since set_file_fault().
int file_calls();

}  // namespace carom::test
