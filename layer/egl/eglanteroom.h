/* EGL extensions of Anteroom's own. Their numbers are of no registry, in none of its blocks. */
#ifndef EGLANTEROOM_H
#define EGLANTEROOM_H

/* EGL_ANTEROOM_context_counters: what a context has done so far, modulo 2^31, by eglQueryContext. It must be
   current in the calling thread: for any other the error is EGL_BAD_ACCESS. */
#define EGL_DRAWS_ANTEROOM 0x3FE0          /* draws that reached the device */
#define EGL_PIPELINES_ANTEROOM 0x3FE1      /* made by its device, for all contexts */
#define EGL_COMPILES_ANTEROOM 0x3FE2       /* shaders compiled from text, the same */
#define EGL_UPLOADED_BYTES_ANTEROOM 0x3FE3 /* of textures */

/* EGL_ANTEROOM_origin: words for people by eglQueryString, of an initialized display.
   The devices that its renderer found, one a line, and what became of each: */
#define EGL_DEVICES_ANTEROOM 0x3FE4
#define EGL_DEVICE_CHOICE_ANTEROOM 0x3FE5 /* why it took the one it has */
#define EGL_DRIVER_ANTEROOM 0x3FE6        /* that one's driver and its version */
#define EGL_SHADER_CACHE_ANTEROOM 0x3FE7  /* the file of compiled shaders, or "none" and why */
#define EGL_QUIRKS_ANTEROOM 0x3FE8        /* what is done about the driver's faults: names, or "" */

#endif
