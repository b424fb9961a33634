#include "app/window/files/file_choice.h"

#include "app/window/files/file_opening.h"

namespace suffuse {

QString openFilter()
{
    return FileOpening::tr("All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj "
                           "*.uim *.inkml *.rnote "
                           "*.svg *.svgz *.pdf *.xml)") +
           ";;" + FileOpening::tr("Suffuse paintings (*.suffuse *.json)") + ";;" +
           FileOpening::tr("Backups of paintings (*.suffuse~* *.json~*)") + ";;" +
           FileOpening::tr("Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)") +
           ";;" + FileOpening::tr("Pictures with layers (*.ora *.psd)") + ";;" +
           FileOpening::tr("Drawings (*.svg *.svgz *.pdf)") + ";;" + FileOpening::tr("Diffusion curves (*.xml)") +
           ";;" + FileOpening::tr("All files (*)");
}

} // namespace suffuse
