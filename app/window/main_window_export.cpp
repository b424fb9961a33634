// Exporting the window's painting, by the dialog and once more without it.
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/export_dialog.h"
#include "app/widgets/messages.h"
#include "app/window/main_window.h"

#include <QDir>
#include <QFileInfo>
#include <QStatusBar>

namespace suffuse {

void MainWindow::connectExport()
{
    connect(&action(Command::Export), &QAction::triggered, this, &MainWindow::exportPicture);
    connect(&action(Command::ExportAgain), &QAction::triggered, this, &MainWindow::exportAgain);
    connect(&m_editor, &Editor::opened, this, [this] {
        const auto last = exports::lastOf(m_editor.filePath());
        m_lastExport = last ? std::make_unique<ExportSettings>(*last) : nullptr;
    });
    m_exportJob = new ExportJob(this);
    connect(m_exportJob, &ExportJob::finished, this, [this](bool written, const QString &error) {
        action(Command::ExportAgain).setEnabled(true);
        statusBar()->clearMessage();
        if (written)
            statusBar()->showMessage(tr("Exported to %1").arg(QDir::toNativeSeparators(m_exportJob->path())), 8'000);
        else if (!error.isEmpty())
            showError(this, error);
    });
}

void MainWindow::exportPicture()
{
    ExportDialog dialog(m_editor, shownArea(m_canvas->view()), this);
    if (m_lastExport)
        dialog.restore(*m_lastExport);
    if (dialog.exec() == QDialog::Accepted)
        m_lastExport = std::make_unique<ExportSettings>(dialog.settings());
}

void MainWindow::exportAgain()
{
    if (!m_lastExport) { // there is nothing to do again yet
        exportPicture();
        return;
    }
    const Result<ExportOrder> order = exportOrder(*m_lastExport, m_editor, shownArea(m_canvas->view()));
    if (!order) {
        showError(this, order.error());
        return;
    }
    action(Command::ExportAgain).setEnabled(false); // until this one is done
    statusBar()->showMessage(tr("Exporting %1…").arg(QFileInfo(order->path).fileName()));
    m_exportJob->start(*order);
}

} // namespace suffuse
