#include "app/dialogs/export/profile_box.h"

#include "app/widgets/asking/choose_profile.h"
#include "model/formats/files.h"
#include "render/image_io/colour_conversion.h"

#include <QFileInfo>

namespace suffuse {

ProfileBox::ProfileBox(const QByteArray &kept, QWidget *parent) : QComboBox(parent), m_profile(kept)
{
    if (!kept.isEmpty() && !ColourConversion::between({{}, kept, {}}))
        m_profile.clear(); // It came with a file, and is of no use.
    fill(hasKept() ? keptIndex : srgbIndex);
    connect(this, &QComboBox::activated, this, [this](int index) {
        if (index == count() - 1)
            askForFile();
        else
            m_before = index;
    });
}

void ProfileBox::fill(int index)
{
    clear();
    addItem(QStringLiteral("sRGB"));
    if (hasKept())
        addItem(titleOfProfile(m_profile, tr("The painting's profile")));
    addItem(tr("From a file…"));
    setCurrentIndex(index);
    m_before = index;
}

void ProfileBox::chooseKept(bool kept)
{
    setCurrentIndex(kept && hasKept() ? keptIndex : srgbIndex);
    m_before = currentIndex();
}

QString ProfileBox::takeFile(const QString &path)
{
    const Result<QByteArray> profile = readProfile(path);
    if (!profile)
        return profile.error();
    if (profile->size() > largestKeptProfile)
        return tr("%1: the profile is too large to be kept in a painting. Choose a smaller one.")
            .arg(QFileInfo(path).fileName());
    if (const auto usable = ColourConversion::between({{}, *profile, {}}); !usable)
        return tr("%1: %2. Choose a profile of RGB colours.").arg(QFileInfo(path).fileName(), usable.error());
    m_profile = *profile;
    fill(keptIndex);
    return {};
}

void ProfileBox::askForFile()
{
    setCurrentIndex(m_before);
    const QString path = askForProfile(this, tr("Profile of the Colours"));
    if (path.isEmpty())
        return;
    if (const QString problem = takeFile(path); !problem.isEmpty())
        emit refused(problem);
}

} // namespace suffuse
