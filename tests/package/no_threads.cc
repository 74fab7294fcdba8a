// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program: the system starts no further thread, as under a container's limit on processes.
#include <cerrno>

#include <pthread.h>

extern "C" int pthread_create(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) { return EAGAIN; }
