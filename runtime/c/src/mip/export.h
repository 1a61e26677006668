/**
 * @file
 * MIP_API marks what a shared library exports.
 *
 * A static library, and sources that are compiled with the program, need none of this. To build a
 * shared library, define MIP_SHARED for the library and its users, and MIP_BUILDING for the library
 * only; CMakeLists.txt and meson.build do.
 */
#ifndef MIP_EXPORT_H
#define MIP_EXPORT_H

#ifndef MIP_SHARED
/** Marks what programs can use of a shared library. */
#define MIP_API
#elif defined(_WIN32) || defined(__CYGWIN__)
#ifdef MIP_BUILDING
#define MIP_API __declspec(dllexport)
#else
#define MIP_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define MIP_API __attribute__((visibility("default")))
#else
#define MIP_API
#endif

#endif
