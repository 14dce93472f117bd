#include "cli/commands.h"
#include "io/draw_png.h"
#include "io/mesh_reader.h"

namespace mesher {

ExitStatus runDraw(const DrawCommand& command, Console console)
{
    if (const Result<void> possible = AtomicFile::probe(command.picture); !possible) {
        return tell(possible.error(), ExitStatus::Failed, console);
    }
    const Result<MeshFile> file = readMesh(command.mesh);
    if (!file) return tell(file.error(), ExitStatus::Failed, console);
    const Result<Image> image = drawMesh(file.value().mesh, command.options);
    if (!image) return tell(image.error(), ExitStatus::Failed, console);
    Result<AtomicFile> target = AtomicFile::create(command.picture);
    if (!target) return tell(target.error(), ExitStatus::Failed, console);
    FileBuffer out(*target);
    writePngFile(image.value(), out);
    Result<void> written = out.finish();
    if (written) written = target->commit();
    if (!written) return tell(written.error(), ExitStatus::Failed, console);
    console.out << "wrote " << command.picture.string() << '\n';
    return ExitStatus::Done;
}

}  // namespace mesher
