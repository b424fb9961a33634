// Every dialog that Suffuse makes itself.
#pragma once

#include "app/dialogs/about_dialog.h"
#include "app/dialogs/export/drawing_dialog.h"
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/timelapse_dialog.h"
#include "app/dialogs/extensions/extension_dialog.h"
#include "app/dialogs/extensions/manage_extensions_dialog.h"
#include "app/dialogs/fit/fit_dialog.h"
#include "app/dialogs/new_dialog.h"
#include "app/dialogs/print/print_dialog.h"
#include "app/dialogs/recolour_dialog.h"
#include "app/dialogs/reshape_dialog.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/dialogs/vary_dialog.h"
#include "app/dialogs/welcome/welcome_dialog.h"
#include "app/panels/brushes/brush_dialog.h"
#include "app/panels/inspector/along/along_dialog.h"
#include "app/session/extensions/extension_library.h"
#include "app/window/files/recovery.h"
#include "app/window/palette_entries.h"
#include "tests/app/shapes.h"

#include <functional>
#include <memory>
#include <vector>

namespace suffuse {

struct DialogMaker {
    const char *name;
    std::function<std::unique_ptr<QDialog>(MainWindow &)> make;
};

inline std::vector<DialogMaker> allDialogs()
{
    const auto area = [](MainWindow &w) { return w.editor().document().painting()->canvas.area(); };
    return {
        {"new", [](MainWindow &w) { return std::make_unique<NewDialog>(&w); }},
        {"settings", [](MainWindow &w) { return std::make_unique<SettingsDialog>(&w); }},
        {"shortcuts",
         [](MainWindow &w) {
             return std::make_unique<ShortcutsDialog>(w.findChild<Commands *>()->all(), fixedKeys(), &w);
         }},
        {"brush", [](MainWindow &w) { return std::make_unique<BrushDialog>(w.editor(), &w); }},
        {"export", [area](MainWindow &w) { return std::make_unique<ExportDialog>(w.editor(), area(w), &w); }},
        {"drawing", [](MainWindow &w) { return std::make_unique<DrawingDialog>(w.editor(), &w); }},
        {"print", [area](MainWindow &w) { return std::make_unique<PrintDialog>(w.editor(), area(w), &w); }},
        {"fit", [](MainWindow &w) { return std::make_unique<FitDialog>(w.editor(), &w); }},
        {"timelapse", [area](MainWindow &w) { return std::make_unique<TimelapseDialog>(w.editor(), area(w), &w); }},
        {"along", [](MainWindow &w) { return std::make_unique<AlongDialog>(w.editor(), &w); }},
        {"reshape", [](MainWindow &w) { return std::make_unique<ReshapeDialog>(w.editor(), Reshaping::Simplify, &w); }},
        {"vary", [](MainWindow &w) { return std::make_unique<VaryDialog>(w.editor(), &w); }},
        {"recolour", [](MainWindow &w) { return std::make_unique<RecolourDialog>(w.editor(), &w); }},
        {"hatch",
         [](MainWindow &w) {
             return std::make_unique<ExtensionDialog>(w.editor(), *ExtensionLibrary::instance().usable("hatch"), &w);
         }},
        {"contact sheet",
         [](MainWindow &w) {
             return std::make_unique<ExtensionDialog>(w.editor(), *ExtensionLibrary::instance().usable("contact-sheet"),
                                                      &w);
         }},
        {"extensions", [](MainWindow &w) { return std::make_unique<ManageExtensionsDialog>(&w); }},
        {"recovery", [](MainWindow &w) { return std::make_unique<RecoveryDialog>(std::vector<LostDocument>(), &w); }},
        {"palette", [](MainWindow &w) { return std::make_unique<CommandPalette>(w.paletteEntries(), &w); }},
        {"welcome", [](MainWindow &w) { return std::make_unique<WelcomeDialog>(&w); }},
        {"about", [](MainWindow &w) { return std::make_unique<AboutDialog>(&w); }},
    };
}

} // namespace suffuse
