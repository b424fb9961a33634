#pragma once

class QString;
class QWidget;

namespace suffuse {

/// Asks for the file of a picture. Returns an empty path if the user gave up. `title` is translated.
QString choosePicture(QWidget *parent, const QString &title);
/// The same for a picture that becomes strokes: files of diffusion curves are such pictures, too.
QString choosePictureToFit(QWidget *parent, const QString &title);

} // namespace suffuse
