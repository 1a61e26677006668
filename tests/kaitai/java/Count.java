// Counts what Mip.java finds in a file: packets, bytes between them, fields, unknown ones, and those that cannot be decoded.
import io.kaitai.struct.ByteBufferKaitaiStream;
import java.nio.file.Files;
import java.nio.file.Path;

public class Count {
    public static void main(String[] arguments) throws Exception {
        Mip log = new Mip(new ByteBufferKaitaiStream(Files.readAllBytes(Path.of(arguments[0]))));
        long packets = 0, between = 0, fields = 0, unknown = 0, wrong = 0;
        for (Mip.Part part : log.parts()) {
            if (!part.isPacket()) {
                between += 1 + part.skipped().rest().length;
                continue;
            }
            packets++;
            for (Mip.Field field : part.packet().payload().fields()) {
                fields++;
                try {
                    if (field.data() instanceof byte[]) {
                        unknown++;
                    }
                } catch (RuntimeException error) {
                    wrong++;
                }
            }
        }
        System.out.println(packets + " " + between + " " + fields + " " + unknown + " " + wrong);
    }
}
