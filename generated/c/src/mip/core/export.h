/**
 * @file
 * Attributes for compilers that know them: MIP_API marks the exports of a shared library,
 * MIP_INLINE, MIP_QUICK and MIP_APART determine which functions are inlined,
 * MIP_CHECKED marks results that callers must check.
 *
 * A static library, and sources that are compiled with the program, need none of this. To build a
 * shared library, define MIP_SHARED for the library and its users, and MIP_BUILDING for the library
 * only; CMakeLists.txt does.
 */
#ifndef MIP_EXPORT_H
#define MIP_EXPORT_H

#ifndef MIP_SHARED
/** Marks the exports of a shared library. */
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

#ifdef __GNUC__
/** Before a function whose result shows whether it has done anything: compilers warn if the result
 * is ignored. */
#define MIP_CHECKED __attribute__((warn_unused_result))
/** Aligns a structure to four bytes; if enumerations have one byte, functions then return it in a
 * register. */
#define MIP_WORD __attribute__((aligned(4)))
#else
/** Before a function whose result shows whether it has done anything. */
#define MIP_CHECKED
/** Aligns a structure to four bytes; without effect here. */
#define MIP_WORD
#endif

#ifndef MIP_ASSERT
#if defined(MIP_DEBUG) && defined(__GNUC__)
/** Stops a program that breaks a rule of a function, in builds with -DMIP_DEBUG. */
#define MIP_ASSERT(condition) ((condition) ? (void)0 : __builtin_trap())
#else
/** Checks a rule of a function in builds with -DMIP_DEBUG, or whatever you define it as. */
#define MIP_ASSERT(condition) ((void)0)
#endif
#endif

#if defined(__has_attribute) && defined(__OPTIMIZE__)
#if __has_attribute(error)
/** After a function that is declared only: a call that is not optimized away is an error. */
#define MIP_REFUSED_BY_COMPILER(why) __attribute__((error(why)))
#endif
#endif

#if defined(__GNUC__)
/** A static function that is inlined into its callers, even where size matters. */
#define MIP_INLINE static inline __attribute__((always_inline))
#else
/** A static function that is inlined into its callers, even where size matters. */
#define MIP_INLINE static inline
#endif

/* Most fields are decoded by one function without calls; the code for others is separate. */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
/** A static function that is inlined into its callers. */
#define MIP_QUICK MIP_INLINE
#else
/** A static function that is inlined into its callers. */
#define MIP_QUICK static inline
#endif

#if defined(__GNUC__)
/** A static function that is not inlined, so that its callers stay small. */
#define MIP_APART static __attribute__((noinline))
#else
/** A static function that is not inlined, so that its callers stay small. */
#define MIP_APART static
#endif

#endif
