// Buffers are shown on an emulated card (tests/board); here is that a file that is no card gives none.
#include "platform/egl_kms/gbm_buffers.hpp"

#include <gtest/gtest.h>

namespace tedavis::platform::test_gbm_buffers {
namespace {

#if defined(TEDAVIS_HAVE_KMS)

TEST(GbmBuffers, WithoutACardThereAreNone) {
    DrmCard card;
    GbmBuffers buffers;
    const base::Error error = buffers.open(card, 64, 48);
    EXPECT_NE(error.message.view().find("GBM does not know this graphics card"), std::string_view::npos) << error.message.c_str();
    EXPECT_EQ(buffers.surface(), nullptr);
    buffers.close();
    buffers.close();
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_gbm_buffers
