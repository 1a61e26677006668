from mip_protocol import gnss_data, registry

print(gnss_data.LlhPosition.INFO.title, "is sent by", *gnss_data.LlhPosition.INFO.devices)
latitude = gnss_data.LlhPosition.INFO["latitude"]
print(latitude.unit, latitude.valid, "-", latitude.text)

data = bytes.fromhex(
    "4046400000000000c052500000000000402800000000000000000000000000003f8000003fc000000001"
)
position = gnss_data.LlhPosition.decode(data)
print(position)
print(position.is_valid("latitude"), position.is_valid("msl_height"))
print(position.to_dict())

print(registry.by_name("temperature_abs").NAME)  # a vendor's name
