#include "app/window/layout/proofing.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/settings/colour_settings.h"
#include "app/widgets/asking/choose_profile.h"
#include "app/widgets/asking/messages.h"

#include <QApplication>
#include <QLabel>
#include <QMainWindow>
#include <QStatusBar>

namespace suffuse {

void recolourWindows()
{
    for (QWidget *window : QApplication::topLevelWidgets())
        if (auto *canvas = window->findChild<CanvasWidget *>())
            canvas->readColours();
}

Proofing::Proofing(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    m_sign = new QLabel(&place.window);
    m_sign->setObjectName("proof");
    m_sign->setContentsMargins(8, 0, 8, 0);
    place.window.statusBar()->addPermanentWidget(m_sign);
    addRows();
    connect(&place.canvas, &CanvasWidget::coloursChanged, this, &Proofing::showSign);
    showSign();
}

void Proofing::addRows()
{
    Commands &table = m_place.commands;
    table
        .add(Command::SoftProof, "softProof", Commands::tr("Soft Proof"), "",
             {QKeySequence(Commands::tr("Ctrl+Shift+Y"))},
             Commands::tr("Shows the colours that are left on another device, as a press, by its profile"))
        .checkedWhen([] { return settings::colours().proofs; })
        .runs([this] { switchProof(); });
    table
        .add(Command::GamutWarning, "gamutWarning", Commands::tr("Gamut &Warning"), "", {},
             Commands::tr("Marks the colours that the device of the soft proof does not have"))
        .when([] { return settings::colours().proofs; }, Commands::tr("Switch the soft proof on first."))
        .checkedWhen([] { return settings::colours().marksGamut; })
        .runs([this] { switchWarning(); });
    table
        .add(Command::ProofProfile, "proofProfile", Commands::tr("Soft Proof with Profile…"), "", {},
             Commands::tr("Chooses the profile of the device whose colours are shown"))
        .runs([this] { chooseProfile(); });
}

void Proofing::take(const ColourSettings &colours)
{
    settings::setColours(colours);
    recolourWindows();
    m_place.commands.update();
}

void Proofing::switchProof()
{
    ColourSettings colours = settings::colours();
    if (!colours.proofs && colours.proofFile.isEmpty()) {
        chooseProfile();
        return m_place.commands.update(); // It was checked by the click.
    }
    colours.proofs = !colours.proofs;
    take(colours);
}

void Proofing::switchWarning()
{
    ColourSettings colours = settings::colours();
    colours.marksGamut = !colours.marksGamut;
    take(colours);
}

void Proofing::chooseProfile()
{
    ColourSettings colours = settings::colours();
    colours.proofFile = askForProfile(&m_place.window, tr("Profile of the Soft Proof"), colours.proofFile);
    if (colours.proofFile.isEmpty())
        return;
    colours.proofs = true;
    if (const Result<ColourConversion> usable = screenConversion(colours, {}); !usable)
        return showError(&m_place.window, usable.error());
    take(colours);
}

void Proofing::showSign()
{
    const CanvasColours &colours = m_place.canvas.colours();
    const QString text = !colours.problem().isEmpty() ? tr("Colours not converted")
                         : colours.proof().isEmpty()  ? QString()
                                                      : tr("Proof: %1").arg(colours.proof());
    m_sign->setText(
        m_sign->fontMetrics().elidedText(text, Qt::ElideRight, m_sign->fontMetrics().averageCharWidth() * 28));
    m_sign->setToolTip(colours.problem().isEmpty() ? text : colours.problem());
    m_sign->setVisible(!text.isEmpty());
    m_place.commands.update();
}

} // namespace suffuse
