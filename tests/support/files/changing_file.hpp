/// A file that another thread writes again and again, as long as this object lives.
#pragma once

#include <atomic>
#include <fstream>
#include <string>
#include <thread>

namespace tedavis::test_support {

class ChangingFile {
public:
    /// Returns when it was written once. It then holds `one` and `other` by turns, and at the end `one`.
    ChangingFile(const std::string& path, const std::string& one, const std::string& other) {
        thread_ = std::thread([=] {
            while (!is_over_) {
                std::ofstream(path, std::ios::binary) << other;
                std::ofstream(path, std::ios::binary) << one;
                is_begun_ = true;
            }
        });
        while (!is_begun_) std::this_thread::yield();
    }
    ~ChangingFile() {
        is_over_ = true;
        thread_.join();
    }
    ChangingFile(const ChangingFile&) = delete;
    ChangingFile& operator=(const ChangingFile&) = delete;

private:
    std::atomic<bool> is_over_{false}, is_begun_{false};
    std::thread thread_;
};

}  // namespace tedavis::test_support
