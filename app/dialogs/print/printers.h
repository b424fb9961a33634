// The printers that the system knows.
#pragma once

#include <QString>

#include <memory>
#include <vector>

class QPagedPaintDevice;

namespace suffuse {

struct PrintTarget;

struct KnownPrinter {
    QString name;  ///< the system's
    QString title; ///< for people
    int dpi = 0;   ///< as fine as it prints
};

namespace printers {

/// How fine a page is where no printer says it.
inline constexpr int usualDpi = 600;

/// All of them, the usual one first.
std::vector<KnownPrinter> all();
/// The printer of a name, ready for the target's page and resolution, with all of the sheet to draw on; null if there
/// is none.
std::shared_ptr<QPagedPaintDevice> ready(const QString &name, const PrintTarget &target, int copies);

} // namespace printers

} // namespace suffuse
