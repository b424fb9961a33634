// Pictures that come into a painting as layers: groups with one stroke that shows a picture.
#pragma once

#include "app/session/files/import_strokes.h"
#include "model/painting/picture.h"
#include "model/result.h"

class QImage;

namespace suffuse {

class Editor;

namespace image_layer {

/// The picture of an image: decoded once, to know its size and that it can be read. `name` stands in messages.
Result<Picture> pictureOf(const EncodedImage &image, const QString &name);

/// Adds a picture of a file on top of all, as a layer with the file's name, selected: in its own size, a pixel a unit,
/// or as large as fits the canvas, with its middle where that of the canvas is. Returns an empty string, or why it
/// could not.
QString importFile(Editor &editor, const QString &path);
/// The same for an image without a file; it lies where `landing` says.
QString paste(Editor &editor, const QImage &image, const Landing &landing);

/// Makes a layer below all of the picture that lies underneath, where it lies, with its opacity. One step.
void takeUnderlay(Editor &editor);

/// The selected strokes that are painted with a picture and not locked.
std::vector<StrokePtr> selectedPictures(const Editor &editor);
/// Their pictures become that of a file, which is linked. Returns an empty string, or why they could not.
QString link(Editor &editor, const QString &path);
/// Their images come into the painting, as far as they are there.
void embed(Editor &editor);
/// Gives them the proportions of their images.
void resetProportions(Editor &editor);

} // namespace image_layer
} // namespace suffuse
