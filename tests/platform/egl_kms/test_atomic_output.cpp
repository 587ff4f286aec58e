// Commits are shown on an emulated card (tests/board); here is that a file that takes none is refused.
#include "platform/egl_kms/atomic_output.hpp"

#include <gtest/gtest.h>

#if defined(TEDAVIS_HAVE_KMS)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace tedavis::platform::test_atomic_output {
namespace {

#if defined(TEDAVIS_HAVE_KMS)

TEST(AtomicOutput, AFileThatTakesNoCommitsIsRefused) {
    const int file = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    ASSERT_GE(file, 0);
    {
        AtomicOutput output;
        EXPECT_FALSE(output.open(file, 1, 2, 0, drmModeModeInfo{}));
        EXPECT_TRUE(output.modifiers().empty());
    }
    EXPECT_EQ(::close(file), 0) << "the file is the caller's";
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_atomic_output
