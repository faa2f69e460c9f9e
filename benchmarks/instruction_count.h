#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

/// Instructions, counted by callgrind: the same every time, whatever else the machine does.
namespace carom::bench {

class InstructionCounter {
  public:
    /// `dumps`: what callgrind was given as --callgrind-out-file. It must have been started with
    /// --instr-atstart=no.
    explicit InstructionCounter(std::string dumps) : dumps_(std::move(dumps)) {}

    /// Instructions that `work` takes. Ends the process with a message when it does not run under
    /// callgrind.
    std::uint64_t count(const std::function<void()>& work);

  private:
    std::string dumps_;
    int dump_ = 0;
};

}  // namespace carom::bench
