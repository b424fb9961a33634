#pragma once

class QString;
class QWidget;

namespace suffuse {

/// Asks for the file of a picture. Returns an empty path if the user gave up. `title` is translated.
QString choosePicture(QWidget *parent, const QString &title);

} // namespace suffuse
