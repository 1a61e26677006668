/** Placeholder. */
#ifndef MIP_EXPORT_H
#define MIP_EXPORT_H
#define MIP_API
#endif
