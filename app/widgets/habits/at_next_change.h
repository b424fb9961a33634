// Messages about what was just done. They disappear as soon as something else is done.
#pragma once

#include <QString>

#include <functional>

class QObject;
class QStatusBar;

namespace suffuse {

class Document;

/// Calls `then` once, at the document's next change of any kind: undo, a new stroke, another selection. It is not
/// called if the context is gone by then.
void atNextChange(const Document &document, QObject *context, std::function<void()> then);

/// Shows a message in the status bar until the document's next change, at most for `milliseconds`.
void sayUntilChange(QStatusBar &bar, const Document &document, const QString &message, int milliseconds = 15'000);

} // namespace suffuse
