! SPDX-License-Identifier: MIT
!> The C interface of microslip for Fortran 2008: the names, arguments and rules are those of microslip.h, which has
!> the comments. Handles are type(c_ptr). Text that goes in ends in c_null_char; text that comes out is a type(c_ptr)
!> that microslip_text() turns into characters. Arrays that come out belong to their handle; c_f_pointer() leads to
!> them. Indices begin at 0. Compile this file with your own and link with -lmicroslip_c.
module microslip
  use, intrinsic :: iso_c_binding
  implicit none
  public

  ! microslip_status
  integer(c_int), parameter :: MICROSLIP_OK = 0_c_int
  integer(c_int), parameter :: MICROSLIP_INPUT = 1_c_int
  integer(c_int), parameter :: MICROSLIP_FORMAT = 2_c_int
  integer(c_int), parameter :: MICROSLIP_FILE = 3_c_int
  integer(c_int), parameter :: MICROSLIP_NOT_CONVERGED = 4_c_int
  integer(c_int), parameter :: MICROSLIP_CANCELLED = 5_c_int
  integer(c_int), parameter :: MICROSLIP_MEMORY = 6_c_int
  integer(c_int), parameter :: MICROSLIP_INTERNAL = 7_c_int

  ! microslip_part_kind
  integer(c_int), parameter :: MICROSLIP_PART_UNIFORM = 0_c_int
  integer(c_int), parameter :: MICROSLIP_PART_POWER_LAW = 1_c_int
  integer(c_int), parameter :: MICROSLIP_PART_PIECEWISE_LINEAR = 2_c_int
  integer(c_int), parameter :: MICROSLIP_PART_ATOMS = 3_c_int
  integer(c_int), parameter :: MICROSLIP_PART_FOUR_PARAMETER = 4_c_int

  ! microslip_level_column
  integer(c_int), parameter :: MICROSLIP_LEVEL_AMPLITUDE_STD = 0_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_DISSIPATION_STD = 1_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_SECANT_STIFFNESS = 2_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_SECANT_STIFFNESS_STD = 3_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_LINEAR_DISSIPATION = 4_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_FREQUENCY = 5_c_int
  integer(c_int), parameter :: MICROSLIP_LEVEL_FREQUENCY_STD = 6_c_int

  ! microslip_identified_values
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_SLIP_FORCE = 0_c_int
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_DENSITY = 1_c_int
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_LOWER = 2_c_int
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_UPPER = 3_c_int

  ! microslip_identified_number
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_COVERED_FROM = 0_c_int
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_COVERED_TO = 1_c_int
  integer(c_int), parameter :: MICROSLIP_IDENTIFIED_LINEAR_DAMPING = 2_c_int

  ! microslip_damping
  integer(c_int), parameter :: MICROSLIP_VISCOUS = 0_c_int
  integer(c_int), parameter :: MICROSLIP_HYSTERETIC = 1_c_int

  ! microslip_response
  integer(c_int), parameter :: MICROSLIP_DISPLACEMENT = 0_c_int
  integer(c_int), parameter :: MICROSLIP_VELOCITY = 1_c_int
  integer(c_int), parameter :: MICROSLIP_ACCELERATION = 2_c_int

  ! microslip_kept
  integer(c_int), parameter :: MICROSLIP_KEEP_FORCE = 0_c_int
  integer(c_int), parameter :: MICROSLIP_KEEP_RESPONSE = 1_c_int

  ! microslip_curve_values_of
  integer(c_int), parameter :: MICROSLIP_CURVE_FREQUENCY = 0_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_FORCE = 1_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_DISPLACEMENT = 2_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_REAL = 3_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_IMAGINARY = 4_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_PHASE = 5_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_DAMPING_RATIO = 6_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_DISSIPATION = 7_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_LINEAR_DISSIPATION = 8_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_IMBALANCE = 9_c_int

  ! microslip_curve_joint_of
  integer(c_int), parameter :: MICROSLIP_CURVE_JOINT_AMPLITUDE = 0_c_int
  integer(c_int), parameter :: MICROSLIP_CURVE_JOINT_DISSIPATION = 1_c_int

  ! microslip_marched_joint_of
  integer(c_int), parameter :: MICROSLIP_MARCHED_JOINT_DISPLACEMENT = 0_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_JOINT_FORCE = 1_c_int

  ! microslip_marched_number
  integer(c_int), parameter :: MICROSLIP_MARCHED_REACHED = 0_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_INITIAL = 1_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_INPUT = 2_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_KINETIC = 3_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_ELASTIC = 4_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_LINEAR = 5_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_JOINT_STORED = 6_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_JOINT_DISSIPATION = 7_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_JOINT_LINEAR = 8_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_IMBALANCE = 9_c_int
  integer(c_int), parameter :: MICROSLIP_MARCHED_ERROR = 10_c_int

  type, bind(c) :: microslip_outcome
    integer(c_size_t) :: struct_size = 0
    integer(c_int) :: converged = 0
    integer(c_int) :: usable = 0
    integer(c_int) :: iterations = 0
    real(c_double) :: residual = 0.0_c_double
    type(c_ptr) :: method = c_null_ptr
    type(c_ptr) :: reason = c_null_ptr
    type(c_ptr) :: summary = c_null_ptr
    integer(c_size_t) :: warning_count = 0
  end type microslip_outcome

  type, bind(c) :: microslip_part
    integer(c_size_t) :: struct_size = 0
    integer(c_int) :: kind = 0
    real(c_double) :: from = 0.0_c_double
    real(c_double) :: to = 0.0_c_double
    real(c_double) :: weight = 0.0_c_double
    real(c_double) :: coefficient = 0.0_c_double
    real(c_double) :: exponent = 0.0_c_double
    integer(c_size_t) :: count = 0
    type(c_ptr) :: slip_force = c_null_ptr
    type(c_ptr) :: value = c_null_ptr
    real(c_double) :: macroslip_force = 0.0_c_double
    real(c_double) :: chi = 0.0_c_double
    real(c_double) :: beta = 0.0_c_double
  end type microslip_part

  type, bind(c) :: microslip_identify_options
    integer(c_size_t) :: struct_size = 0
    real(c_double) :: stiffness = 0.0_c_double
    type(c_ptr) :: method = c_null_ptr
    type(c_ptr) :: smoothing = c_null_ptr
    type(c_ptr) :: smoothing_unit = c_null_ptr
    type(c_ptr) :: fit = c_null_ptr
    integer(c_int) :: linear_damping = 0
    integer(c_int) :: atom = 0
    integer(c_int) :: edges = 0
    integer(c_size_t) :: bands = 0
    real(c_double) :: confidence = 0.0_c_double
    integer(c_int64_t) :: seed = 0
    real(c_double) :: dissipation_gain_std = 0.0_c_double
    real(c_double) :: amplitude_gain_std = 0.0_c_double
    real(c_double) :: loss_factor_std = 0.0_c_double
    integer(c_int) :: threads = 0
    type(c_ptr) :: command = c_null_ptr
    type(c_funptr) :: progress = c_null_funptr
    type(c_ptr) :: user = c_null_ptr
  end type microslip_identify_options

  type, bind(c) :: microslip_joint_options
    integer(c_size_t) :: struct_size = 0
    real(c_double) :: spring_in_modes = 0.0_c_double
    real(c_double) :: series_compliance = 0.0_c_double
    real(c_double) :: linear_damping = 0.0_c_double
  end type microslip_joint_options

  type, bind(c) :: microslip_frf_options
    integer(c_size_t) :: struct_size = 0
    integer(c_size_t) :: harmonics = 0
    integer(c_size_t) :: samples = 0
    real(c_double) :: tolerance = 0.0_c_double
    integer(c_int) :: max_iterations = 0
    real(c_double) :: largest_change = 0.0_c_double
    integer(c_int) :: least_points = 0
    integer(c_int) :: max_points = 0
    real(c_double) :: accuracy = 0.0_c_double
    integer(c_size_t) :: at_count = 0
    type(c_ptr) :: at = c_null_ptr
    integer(c_int) :: response = 0
    integer(c_int) :: modal_forcing = 0
    integer(c_int) :: judge = 0
    type(c_funptr) :: progress = c_null_funptr
    type(c_ptr) :: user = c_null_ptr
  end type microslip_frf_options

  type, bind(c) :: microslip_march_options
    integer(c_size_t) :: struct_size = 0
    real(c_double) :: step = 0.0_c_double
    integer(c_size_t) :: every = 0
    real(c_double) :: tolerance = 0.0_c_double
    integer(c_int) :: max_iterations = 0
    real(c_double) :: largest_imbalance = 0.0_c_double
    integer(c_int) :: estimate_error = 0
    real(c_double) :: largest_error = 0.0_c_double
    integer(c_size_t) :: start_modes = 0
    type(c_ptr) :: start_displacement = c_null_ptr
    type(c_ptr) :: start_velocity = c_null_ptr
    type(c_funptr) :: progress = c_null_funptr
    type(c_ptr) :: user = c_null_ptr
  end type microslip_march_options

  interface
    function microslip_last_error() bind(c)
      import
      type(c_ptr) :: microslip_last_error
    end function microslip_last_error

    function microslip_version() bind(c)
      import
      type(c_ptr) :: microslip_version
    end function microslip_version

    function microslip_part_defaults(part, struct_size) bind(c)
      import
      integer(c_int) :: microslip_part_defaults
      type(microslip_part), intent(inout) :: part
      integer(c_size_t), value :: struct_size
    end function microslip_part_defaults

    function microslip_joint_create(stiffness, parts, count, joint) bind(c)
      import
      integer(c_int) :: microslip_joint_create
      real(c_double), value :: stiffness
      type(microslip_part), intent(in) :: parts(*)
      integer(c_size_t), value :: count
      type(c_ptr), intent(out) :: joint
    end function microslip_joint_create

    function microslip_joint_read(path, joint) bind(c)
      import
      integer(c_int) :: microslip_joint_read
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: joint
    end function microslip_joint_read

    function microslip_joint_parse(text, joint) bind(c)
      import
      integer(c_int) :: microslip_joint_parse
      character(kind=c_char), intent(in) :: text(*)
      type(c_ptr), intent(out) :: joint
    end function microslip_joint_parse

    function microslip_joint_write(joint, path) bind(c)
      import
      integer(c_int) :: microslip_joint_write
      type(c_ptr), value :: joint
      character(kind=c_char), intent(in) :: path(*)
    end function microslip_joint_write

    function microslip_joint_text(joint, text) bind(c)
      import
      integer(c_int) :: microslip_joint_text
      type(c_ptr), value :: joint
      type(c_ptr), intent(out) :: text
    end function microslip_joint_text

    subroutine microslip_joint_destroy(joint) bind(c)
      import
      type(c_ptr), value :: joint
    end subroutine microslip_joint_destroy

    function microslip_joint_stiffness(joint, stiffness) bind(c)
      import
      integer(c_int) :: microslip_joint_stiffness
      type(c_ptr), value :: joint
      real(c_double), intent(out) :: stiffness
    end function microslip_joint_stiffness

    function microslip_joint_part_count(joint, count) bind(c)
      import
      integer(c_int) :: microslip_joint_part_count
      type(c_ptr), value :: joint
      integer(c_size_t), intent(out) :: count
    end function microslip_joint_part_count

    function microslip_joint_part(joint, index, part) bind(c)
      import
      integer(c_int) :: microslip_joint_part
      type(c_ptr), value :: joint
      integer(c_size_t), value :: index
      type(microslip_part), intent(inout) :: part
    end function microslip_joint_part

    function microslip_virgin_force(joint, count, displacement, force) bind(c)
      import
      integer(c_int) :: microslip_virgin_force
      type(c_ptr), value :: joint
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: displacement(*)
      real(c_double), intent(inout) :: force(*)
    end function microslip_virgin_force

    function microslip_tangent_stiffness(joint, count, displacement, stiffness) bind(c)
      import
      integer(c_int) :: microslip_tangent_stiffness
      type(c_ptr), value :: joint
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: displacement(*)
      real(c_double), intent(inout) :: stiffness(*)
    end function microslip_tangent_stiffness

    function microslip_dissipation(joint, count, amplitude, energy) bind(c)
      import
      integer(c_int) :: microslip_dissipation
      type(c_ptr), value :: joint
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: amplitude(*)
      real(c_double), intent(inout) :: energy(*)
    end function microslip_dissipation

    function microslip_secant_stiffness(joint, count, amplitude, stiffness) bind(c)
      import
      integer(c_int) :: microslip_secant_stiffness
      type(c_ptr), value :: joint
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: amplitude(*)
      real(c_double), intent(inout) :: stiffness(*)
    end function microslip_secant_stiffness

    function microslip_density(joint, count, slip_force, density) bind(c)
      import
      integer(c_int) :: microslip_density
      type(c_ptr), value :: joint
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: slip_force(*)
      real(c_double), intent(inout) :: density(*)
    end function microslip_density

    function microslip_memory_create(joint, memory) bind(c)
      import
      integer(c_int) :: microslip_memory_create
      type(c_ptr), value :: joint
      type(c_ptr), intent(out) :: memory
    end function microslip_memory_create

    function microslip_memory_copy(memory, copy) bind(c)
      import
      integer(c_int) :: microslip_memory_copy
      type(c_ptr), value :: memory
      type(c_ptr), intent(out) :: copy
    end function microslip_memory_copy

    function microslip_memory_assign(memory, from) bind(c)
      import
      integer(c_int) :: microslip_memory_assign
      type(c_ptr), value :: memory
      type(c_ptr), value :: from
    end function microslip_memory_assign

    subroutine microslip_memory_destroy(memory) bind(c)
      import
      type(c_ptr), value :: memory
    end subroutine microslip_memory_destroy

    function microslip_memory_trial(memory, displacement, force, tangent) bind(c)
      import
      integer(c_int) :: microslip_memory_trial
      type(c_ptr), value :: memory
      real(c_double), value :: displacement
      real(c_double), intent(out) :: force
      real(c_double), intent(out) :: tangent
    end function microslip_memory_trial

    function microslip_memory_advance(memory, displacement, force) bind(c)
      import
      integer(c_int) :: microslip_memory_advance
      type(c_ptr), value :: memory
      real(c_double), value :: displacement
      real(c_double), intent(out) :: force
    end function microslip_memory_advance

    function microslip_memory_march(memory, count, displacement, force) bind(c)
      import
      integer(c_int) :: microslip_memory_march
      type(c_ptr), value :: memory
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: displacement(*)
      real(c_double), intent(inout) :: force(*)
    end function microslip_memory_march

    function microslip_memory_dissipation(memory, displacement, energy) bind(c)
      import
      integer(c_int) :: microslip_memory_dissipation
      type(c_ptr), value :: memory
      real(c_double), value :: displacement
      real(c_double), intent(out) :: energy
    end function microslip_memory_dissipation

    function microslip_memory_stored_energy(memory, energy) bind(c)
      import
      integer(c_int) :: microslip_memory_stored_energy
      type(c_ptr), value :: memory
      real(c_double), intent(out) :: energy
    end function microslip_memory_stored_energy

    function microslip_memory_state(memory, displacement, force) bind(c)
      import
      integer(c_int) :: microslip_memory_state
      type(c_ptr), value :: memory
      real(c_double), intent(out) :: displacement
      real(c_double), intent(out) :: force
    end function microslip_memory_state

    function microslip_memory_reset(memory) bind(c)
      import
      integer(c_int) :: microslip_memory_reset
      type(c_ptr), value :: memory
    end function microslip_memory_reset

    function microslip_levels_create(count, amplitude, dissipation, levels) bind(c)
      import
      integer(c_int) :: microslip_levels_create
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: amplitude(*)
      real(c_double), intent(in) :: dissipation(*)
      type(c_ptr), intent(out) :: levels
    end function microslip_levels_create

    function microslip_levels_set(levels, column, count, values) bind(c)
      import
      integer(c_int) :: microslip_levels_set
      type(c_ptr), value :: levels
      integer(c_int), value :: column
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: values(*)
    end function microslip_levels_set

    function microslip_levels_read(path, levels) bind(c)
      import
      integer(c_int) :: microslip_levels_read
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: levels
    end function microslip_levels_read

    function microslip_levels_count(levels, count) bind(c)
      import
      integer(c_int) :: microslip_levels_count
      type(c_ptr), value :: levels
      integer(c_size_t), intent(out) :: count
    end function microslip_levels_count

    subroutine microslip_levels_destroy(levels) bind(c)
      import
      type(c_ptr), value :: levels
    end subroutine microslip_levels_destroy

    function microslip_identify_options_defaults(options, struct_size) bind(c)
      import
      integer(c_int) :: microslip_identify_options_defaults
      type(microslip_identify_options), intent(inout) :: options
      integer(c_size_t), value :: struct_size
    end function microslip_identify_options_defaults

    function microslip_identify(levels, options, identification) bind(c)
      import
      integer(c_int) :: microslip_identify
      type(c_ptr), value :: levels
      type(microslip_identify_options), intent(in) :: options
      type(c_ptr), intent(out) :: identification
    end function microslip_identify

    subroutine microslip_identification_destroy(identification) bind(c)
      import
      type(c_ptr), value :: identification
    end subroutine microslip_identification_destroy

    function microslip_identification_joint(identification, joint) bind(c)
      import
      integer(c_int) :: microslip_identification_joint
      type(c_ptr), value :: identification
      type(c_ptr), intent(out) :: joint
    end function microslip_identification_joint

    function microslip_identification_values(identification, what, values, count) bind(c)
      import
      integer(c_int) :: microslip_identification_values
      type(c_ptr), value :: identification
      integer(c_int), value :: what
      type(c_ptr), intent(out) :: values
      integer(c_size_t), intent(out) :: count
    end function microslip_identification_values

    function microslip_identification_number(identification, what, value) bind(c)
      import
      integer(c_int) :: microslip_identification_number
      type(c_ptr), value :: identification
      integer(c_int), value :: what
      real(c_double), intent(out) :: value
    end function microslip_identification_number

    function microslip_identification_outcome(identification, outcome) bind(c)
      import
      integer(c_int) :: microslip_identification_outcome
      type(c_ptr), value :: identification
      type(microslip_outcome), intent(inout) :: outcome
    end function microslip_identification_outcome

    function microslip_identification_warning(identification, index, code, text) bind(c)
      import
      integer(c_int) :: microslip_identification_warning
      type(c_ptr), value :: identification
      integer(c_size_t), value :: index
      type(c_ptr), intent(out) :: code
      type(c_ptr), intent(out) :: text
    end function microslip_identification_warning

    function microslip_model_create(modes, frequency, loss_factor, damping, model) bind(c)
      import
      integer(c_int) :: microslip_model_create
      integer(c_size_t), value :: modes
      real(c_double), intent(in) :: frequency(*)
      real(c_double), intent(in) :: loss_factor(*)
      integer(c_int), value :: damping
      type(c_ptr), intent(out) :: model
    end function microslip_model_create

    subroutine microslip_model_destroy(model) bind(c)
      import
      type(c_ptr), value :: model
    end subroutine microslip_model_destroy

    function microslip_model_add_point(model, name, modes, shape) bind(c)
      import
      integer(c_int) :: microslip_model_add_point
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: name(*)
      integer(c_size_t), value :: modes
      real(c_double), intent(in) :: shape(*)
    end function microslip_model_add_point

    function microslip_joint_options_defaults(options, struct_size) bind(c)
      import
      integer(c_int) :: microslip_joint_options_defaults
      type(microslip_joint_options), intent(inout) :: options
      integer(c_size_t), value :: struct_size
    end function microslip_joint_options_defaults

    function microslip_model_add_joint(model, name, joint, modes, shape, options) bind(c)
      import
      integer(c_int) :: microslip_model_add_joint
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: name(*)
      type(c_ptr), value :: joint
      integer(c_size_t), value :: modes
      real(c_double), intent(in) :: shape(*)
      type(microslip_joint_options), intent(in) :: options
    end function microslip_model_add_joint

    function microslip_model_add_excitation(model, point, harmonics, real, imaginary) bind(c)
      import
      integer(c_int) :: microslip_model_add_excitation
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: point(*)
      integer(c_size_t), value :: harmonics
      real(c_double), intent(in) :: real(*)
      real(c_double), intent(in) :: imaginary(*)
    end function microslip_model_add_excitation

    function microslip_model_add_static_load(model, point, force) bind(c)
      import
      integer(c_int) :: microslip_model_add_static_load
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: point(*)
      real(c_double), value :: force
    end function microslip_model_add_static_load

    function microslip_structure_create(model, structure) bind(c)
      import
      integer(c_int) :: microslip_structure_create
      type(c_ptr), value :: model
      type(c_ptr), intent(out) :: structure
    end function microslip_structure_create

    function microslip_structure_read(path, structure) bind(c)
      import
      integer(c_int) :: microslip_structure_read
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: structure
    end function microslip_structure_read

    subroutine microslip_structure_destroy(structure) bind(c)
      import
      type(c_ptr), value :: structure
    end subroutine microslip_structure_destroy

    function microslip_structure_stuck_frequencies(structure, frequency, count) bind(c)
      import
      integer(c_int) :: microslip_structure_stuck_frequencies
      type(c_ptr), value :: structure
      type(c_ptr), intent(out) :: frequency
      integer(c_size_t), intent(out) :: count
    end function microslip_structure_stuck_frequencies

    function microslip_structure_counts(structure, points, joints) bind(c)
      import
      integer(c_int) :: microslip_structure_counts
      type(c_ptr), value :: structure
      integer(c_size_t), intent(out) :: points
      integer(c_size_t), intent(out) :: joints
    end function microslip_structure_counts

    function microslip_structure_point(structure, index, name) bind(c)
      import
      integer(c_int) :: microslip_structure_point
      type(c_ptr), value :: structure
      integer(c_size_t), value :: index
      type(c_ptr), intent(out) :: name
    end function microslip_structure_point

    function microslip_structure_joint(structure, index, name) bind(c)
      import
      integer(c_int) :: microslip_structure_joint
      type(c_ptr), value :: structure
      integer(c_size_t), value :: index
      type(c_ptr), intent(out) :: name
    end function microslip_structure_joint

    function microslip_frf_options_defaults(options, struct_size) bind(c)
      import
      integer(c_int) :: microslip_frf_options_defaults
      type(microslip_frf_options), intent(inout) :: options
      integer(c_size_t), value :: struct_size
    end function microslip_frf_options_defaults

    function microslip_frf(structure, point, kept, value, from, to, options, curve) bind(c)
      import
      integer(c_int) :: microslip_frf
      type(c_ptr), value :: structure
      character(kind=c_char), intent(in) :: point(*)
      integer(c_int), value :: kept
      real(c_double), value :: value
      real(c_double), value :: from
      real(c_double), value :: to
      type(microslip_frf_options), intent(in) :: options
      type(c_ptr), intent(out) :: curve
    end function microslip_frf

    function microslip_backbone(structure, point, mode, count, response, options, curve) bind(c)
      import
      integer(c_int) :: microslip_backbone
      type(c_ptr), value :: structure
      character(kind=c_char), intent(in) :: point(*)
      integer(c_size_t), value :: mode
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: response(*)
      type(microslip_frf_options), intent(in) :: options
      type(c_ptr), intent(out) :: curve
    end function microslip_backbone

    subroutine microslip_curve_destroy(curve) bind(c)
      import
      type(c_ptr), value :: curve
    end subroutine microslip_curve_destroy

    function microslip_curve_values(curve, what, values, count) bind(c)
      import
      integer(c_int) :: microslip_curve_values
      type(c_ptr), value :: curve
      integer(c_int), value :: what
      type(c_ptr), intent(out) :: values
      integer(c_size_t), intent(out) :: count
    end function microslip_curve_values

    function microslip_curve_joint(curve, joint, what, values, count) bind(c)
      import
      integer(c_int) :: microslip_curve_joint
      type(c_ptr), value :: curve
      integer(c_size_t), value :: joint
      integer(c_int), value :: what
      type(c_ptr), intent(out) :: values
      integer(c_size_t), intent(out) :: count
    end function microslip_curve_joint

    function microslip_curve_harmonic(curve, point, harmonic, count, real, imaginary) bind(c)
      import
      integer(c_int) :: microslip_curve_harmonic
      type(c_ptr), value :: curve
      character(kind=c_char), intent(in) :: point(*)
      integer(c_size_t), value :: harmonic
      integer(c_size_t), value :: count
      real(c_double), intent(inout) :: real(*)
      real(c_double), intent(inout) :: imaginary(*)
    end function microslip_curve_harmonic

    function microslip_curve_peaks(curve, index, count) bind(c)
      import
      integer(c_int) :: microslip_curve_peaks
      type(c_ptr), value :: curve
      type(c_ptr), intent(out) :: index
      integer(c_size_t), intent(out) :: count
    end function microslip_curve_peaks

    function microslip_curve_outcome(curve, outcome) bind(c)
      import
      integer(c_int) :: microslip_curve_outcome
      type(c_ptr), value :: curve
      type(microslip_outcome), intent(inout) :: outcome
    end function microslip_curve_outcome

    function microslip_curve_warning(curve, index, code, text) bind(c)
      import
      integer(c_int) :: microslip_curve_warning
      type(c_ptr), value :: curve
      integer(c_size_t), value :: index
      type(c_ptr), intent(out) :: code
      type(c_ptr), intent(out) :: text
    end function microslip_curve_warning

    function microslip_march_options_defaults(options, struct_size) bind(c)
      import
      integer(c_int) :: microslip_march_options_defaults
      type(microslip_march_options), intent(inout) :: options
      integer(c_size_t), value :: struct_size
    end function microslip_march_options_defaults

    function microslip_march(structure, count, time, load_count, places, loads, options, marched) bind(c)
      import
      integer(c_int) :: microslip_march
      type(c_ptr), value :: structure
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: time(*)
      integer(c_size_t), value :: load_count
      type(c_ptr), intent(in) :: places(*)
      type(c_ptr), intent(in) :: loads(*)
      type(microslip_march_options), intent(in) :: options
      type(c_ptr), intent(out) :: marched
    end function microslip_march

    subroutine microslip_marched_destroy(marched) bind(c)
      import
      type(c_ptr), value :: marched
    end subroutine microslip_marched_destroy

    function microslip_marched_time(marched, time, count) bind(c)
      import
      integer(c_int) :: microslip_marched_time
      type(c_ptr), value :: marched
      type(c_ptr), intent(out) :: time
      integer(c_size_t), intent(out) :: count
    end function microslip_marched_time

    function microslip_marched_point(marched, point, what, values, count) bind(c)
      import
      integer(c_int) :: microslip_marched_point
      type(c_ptr), value :: marched
      integer(c_size_t), value :: point
      integer(c_int), value :: what
      type(c_ptr), intent(out) :: values
      integer(c_size_t), intent(out) :: count
    end function microslip_marched_point

    function microslip_marched_joint(marched, joint, what, values, count) bind(c)
      import
      integer(c_int) :: microslip_marched_joint
      type(c_ptr), value :: marched
      integer(c_size_t), value :: joint
      integer(c_int), value :: what
      type(c_ptr), intent(out) :: values
      integer(c_size_t), intent(out) :: count
    end function microslip_marched_joint

    function microslip_marched_value(marched, what, value) bind(c)
      import
      integer(c_int) :: microslip_marched_value
      type(c_ptr), value :: marched
      integer(c_int), value :: what
      real(c_double), intent(out) :: value
    end function microslip_marched_value

    function microslip_marched_outcome(marched, outcome) bind(c)
      import
      integer(c_int) :: microslip_marched_outcome
      type(c_ptr), value :: marched
      type(microslip_outcome), intent(inout) :: outcome
    end function microslip_marched_outcome

    function microslip_marched_warning(marched, index, code, text) bind(c)
      import
      integer(c_int) :: microslip_marched_warning
      type(c_ptr), value :: marched
      integer(c_size_t), value :: index
      type(c_ptr), intent(out) :: code
      type(c_ptr), intent(out) :: text
    end function microslip_marched_warning

    function microslip_strlen(text) bind(c, name='strlen')
      import
      integer(c_size_t) :: microslip_strlen
      type(c_ptr), value :: text
    end function microslip_strlen
  end interface

contains

  !> The characters of a C string of microslip.
  function microslip_text(text) result(characters)
    type(c_ptr), intent(in) :: text
    character(len=:), allocatable :: characters
    character(kind=c_char), pointer :: all(:)
    integer :: i
    call c_f_pointer(text, all, [microslip_strlen(text)])
    allocate (character(len=size(all)) :: characters)
    do i = 1, size(all)
      characters(i:i) = all(i)
    end do
  end function microslip_text

end module microslip
