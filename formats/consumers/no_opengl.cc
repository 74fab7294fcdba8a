// SPDX-License-Identifier: BSD-3-Clause
// The static OpenCV asks the X server's library for OpenGL's functions; the module draws nothing, and would load eight
// libraries for it. Asked all the same, OpenCV throws that there is no such function.

// NOLINTNEXTLINE(readability-identifier-naming): the X server's name
extern "C" void (*glXGetProcAddressARB(const unsigned char* /*name*/))() { return nullptr; }
