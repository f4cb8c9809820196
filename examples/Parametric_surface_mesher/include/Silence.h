// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SILENCE_H
#define SILENCE_H

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

#include <iostream>
#include <mutex>
#include <sstream>
#include <streambuf>

namespace mesh_cad {

// Suppresses the messages about a file that Open CASCADE's readers write to std::cout, as long as the object exists. There is one of
// them at a time, since each puts back what it has found.
class Silence
{
  std::lock_guard<std::mutex> m_lock{mutex()};
  std::ostringstream m_nowhere;
  std::streambuf* m_buffer;

public:
  Silence() : m_buffer(std::cout.rdbuf(m_nowhere.rdbuf()))
  {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); // permanently
  }
  ~Silence() { std::cout.rdbuf(m_buffer); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  static std::mutex& mutex()
  {
    static std::mutex result;
    return result;
  }
};

} // namespace mesh_cad

#endif // SILENCE_H
