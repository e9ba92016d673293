import os, sys, shutil
from right import R
from wrong import W
import more
R.update(more.R); W.update(more.W)
INC = "\n".join("#include <%s>" % h for h in "algorithm array cstdio map memory mutex cmath complex cstdint cstdlib exception numbers optional utility valarray vector".split())
out = sys.argv[1]
for d in (R, W):
    for name, body in d.items():
        f = os.path.join(out, name); os.makedirs(f, exist_ok=True)
        head = "#include <raytracer/geometry/BumpySphere.h>\n\n" + INC + "\n\n"
        if body.startswith("FILE"): text = head + body[4:].lstrip()
        else: text = head + "namespace raytracer {\nVector3 BumpySphere::getNormalAt(const Vector3& position) const {\n    // TASK T1 begin\n" + body.strip("\n") + "\n    // TASK T1 end\n}\n}  // namespace raytracer\n"
        open(os.path.join(f, "BumpySphere.cpp"), "w").write(text)
        shutil.copy("/work/wt/outside5-t1/student_template/exercise/Renderer.cpp", f)
