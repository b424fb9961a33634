#pragma once

class QString;
class QWidget;

namespace suffuse {

/// Asks for a picture's file; empty: given up. `title` is translated.
QString choosePicture(QWidget *parent, const QString &title);

} // namespace suffuse
