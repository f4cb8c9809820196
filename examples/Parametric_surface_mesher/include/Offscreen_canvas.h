// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_OFFSCREEN_CANVAS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_OFFSCREEN_CANVAS_H

/*!
\file Offscreen_canvas.h

A z-buffer to draw in: OpenGL without a window, by EGL, which uses the processor if there is no graphics card.
*/

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace mesh_picture {

/// An image of red, green and blue bytes, row by row from the top.
struct Image
{
  std::size_t width, height;
  std::vector<std::uint8_t> bytes;
};

/// Draws triangles and lines; what is nearer hides what is behind it. One at a time.
class Offscreen_canvas
{
  GLsizei m_width, m_height;
  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLContext m_context = EGL_NO_CONTEXT;

public:
  /// \throws std::runtime_error if there is no driver that draws without a window, or the image is too large for it
  Offscreen_canvas(std::size_t columns, std::size_t rows) : m_width(GLsizei(columns)), m_height(GLsizei(rows))
  {
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if(get_display)
      m_display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    try {
      make_context();
      make_buffers();
    }
    catch(...) {
      end();
      throw;
    }
    glViewport(0, 0, m_width, m_height);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_POLYGON_OFFSET_FILL); // lines lie in front of the triangles beside them
    glPolygonOffset(1, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
  }

  ~Offscreen_canvas() { end(); }
  Offscreen_canvas(const Offscreen_canvas&) = delete;
  Offscreen_canvas& operator=(const Offscreen_canvas&) = delete;

  /// draws triangles; `points` has three coordinates for each corner, from -1 to 1, the third one larger where it is farther away, and
  /// `colors` three bytes.
  void draw_triangles(const std::vector<float>& points, const std::vector<std::uint8_t>& colors)
  {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, colors.data());
    glVertexPointer(3, GL_FLOAT, 0, points.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(points.size() / 3));
    glDisableClientState(GL_COLOR_ARRAY);
  }

  /// draws the edges of triangles, as far as they were not hidden.
  void draw_edges(const std::vector<float>& points, float pen_width, float opacity)
  {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    set_pen(pen_width, opacity);
    glVertexPointer(3, GL_FLOAT, 0, points.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(points.size() / 3));
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }

  /// draws lines; `points` has the coordinates of both ends of each.
  void draw_lines(const std::vector<float>& points, float pen_width)
  {
    set_pen(pen_width, 1);
    glVertexPointer(3, GL_FLOAT, 0, points.data());
    glDrawArrays(GL_LINES, 0, GLsizei(points.size() / 3));
  }

  /// what was drawn.
  Image image() const
  {
    const std::size_t row = 3 * std::size_t(m_width);
    Image result{std::size_t(m_width), std::size_t(m_height), std::vector<std::uint8_t>(row * std::size_t(m_height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for(GLsizei y = 0; y < m_height; ++y) // the first row of OpenGL is at the bottom
      glReadPixels(0, m_height - 1 - y, m_width, 1, GL_RGB, GL_UNSIGNED_BYTE, result.bytes.data() + row * std::size_t(y));
    return result;
  }

private:
  static void set_pen(float pen_width, float opacity)
  {
    glLineWidth(pen_width);
    glColor4f(0.11f, 0.15f, 0.20f, opacity);
  }

  void make_context()
  {
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config;
    EGLint number = 0;
    const bool is_there = m_display != EGL_NO_DISPLAY && eglInitialize(m_display, nullptr, nullptr) && eglBindAPI(EGL_OPENGL_API)
                          && eglChooseConfig(m_display, wanted, &config, 1, &number) && number > 0;
    if(is_there)
      m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, nullptr);
    if(m_context == EGL_NO_CONTEXT || !eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
      throw std::runtime_error("there is no driver of OpenGL that draws without a window; install one (libgl1-mesa-dri of Debian), or "
                               "write the picture as .svg");
  }

  void make_buffers() const
  {
    GLuint frame, color, depth;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGB8, m_width, m_height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, m_width, m_height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    if(glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw std::runtime_error("the picture is too large for the driver of OpenGL; write it as .svg");
  }

  // Buffers go with their context.
  void end()
  {
    if(m_display == EGL_NO_DISPLAY)
      return;
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if(m_context != EGL_NO_CONTEXT)
      eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
  }
};

} // namespace mesh_picture

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_OFFSCREEN_CANVAS_H
