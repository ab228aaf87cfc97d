#pragma once
// What a listener touches: a flag that ends a wait. Private to common/dds. Thread-safe; a
// notification that comes before the wait is not lost, and may end one wait too many.
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace ronda::dds {

class Wakeup {
 public:
  void Notify() {
    {
      const std::lock_guard lock(mutex_);
      notified_ = true;
    }
    condition_.notify_one();
  }

  void Wait(std::chrono::milliseconds at_most) {
    std::unique_lock lock(mutex_);
    condition_.wait_for(lock, at_most, [this] { return notified_; });
    notified_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool notified_ = false;
};

}  // namespace ronda::dds
