// The page that shows a Deep Zoom picture in a browser.
#pragma once

#include <QByteArray>
#include <QString>

namespace suffuse {

struct DeepZoomPage {
    QString files, ending; ///< the folder of tiles beside the page, and how their names end
    int width = 0, height = 0;
    int tile = 0, overlap = 0;
};

/// One HTML file that needs nothing but the tiles beside it: no network and no library. It pans, zooms at the pointer,
/// by wheel, pinch and keys, and shows coarser tiles until the finer ones have come.
QByteArray deepZoomPage(const DeepZoomPage &page);
/// Whether a file begins as such a page does, of whatever version.
bool isDeepZoomPage(const QByteArray &bytes);

} // namespace suffuse
